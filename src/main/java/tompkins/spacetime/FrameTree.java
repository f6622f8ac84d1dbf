package tompkins.spacetime;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;

/**
 * The inertial frames of a photograph and the ways between them: the scene frame, and in it the frame of the camera and
 * those of what moves.
 *
 * <p>A camera that has flown for a long time is far from the origin of the scene frame, and so is everything that it
 * sees: with coordinates of order 1e7 a double does not have enough digits for rods of radius 0.02. Then the
 * coordinates of a frame begin at an event near the camera (given by doubles, which are subtracted exactly from the
 * objects), and the ways between frames are about the lens, whose event in each frame is worked out once with sixty
 * digits. The coordinates of the camera frame always begin at its origin.
 */
public final class FrameTree {

    /** A frame gets an origin of its own if the camera is farther from its origin, in space or time. */
    private static final double FAR = 1000;

    private final TransformationLaw law;
    private final FrameMotion camera;

    /** Null if no coordinates need to begin near it. */
    private final Event lens;

    /** The changes of frame that were worked out before, each from the frame around a frame to that frame. */
    private final Map<FrameMotion, FrameRoute.Step> steps = Collections.synchronizedMap(new IdentityHashMap<>());

    /** The events at the lens that were worked out before. */
    private final Map<FrameMotion, PreciseEvent> lensEvents = Collections.synchronizedMap(new IdentityHashMap<>());

    private FrameTree(TransformationLaw law, Velocity velocity, Event lens) {
        this.law = law;
        this.lens = lens;
        camera = new FrameMotion(null, velocity, Event.ORIGIN);
    }

    /**
     * The frames as they are described, each in coordinates that begin at its own origin.
     *
     * @param law how coordinates change from frame to frame
     * @param velocity that of the camera in the scene frame; its origin passes that of the scene frame at time 0
     */
    public static FrameTree described(TransformationLaw law, Velocity velocity) {
        return new FrameTree(law, velocity, null);
    }

    /** As above, without a camera that moves. */
    public static FrameTree described(TransformationLaw law) {
        return described(law, Velocity.REST);
    }

    /**
     * As above, in coordinates that begin near a camera if it is far away.
     *
     * @param lens an event at the lens, in the camera frame; without a finite time it is in no other frame
     */
    public static FrameTree near(Event lens, TransformationLaw law, Velocity velocity) {
        return new FrameTree(law, velocity, Double.isFinite(lens.time()) ? lens : null);
    }

    /** How coordinates change from frame to frame. */
    public TransformationLaw law() {
        return law;
    }

    /** How the camera moves; null instead of it means the scene frame. */
    public FrameMotion camera() {
        return camera;
    }

    /** The event at which the coordinates of a frame begin; usually (0, 0, 0) at time 0. */
    public Event origin(FrameMotion motion) {
        if (motion == camera || lens == null) {
            return Event.ORIGIN;
        }
        if (motion == null) {
            SpaceTimeTransformation toScene = law.sceneFromCamera(camera.velocity());
            Event inScene = toScene.transform(lens);
            // a camera at rest has not moved away from what it sees
            boolean isAtRest = toScene instanceof IdentityTransformation;
            return origin(isAtRest ? new Event(0, 0, 0, inScene.time()) : inScene);
        }
        return origin(lensIn(motion).rounded());
    }

    /** Where coordinates begin, for a lens at an event. */
    private static Event origin(Event lens) {
        Vector3d place = lens.position();
        boolean isFar = place.isFinite() && place.length() >= FAR;
        double time = Double.isFinite(lens.time()) && Math.abs(lens.time()) >= FAR ? lens.time() : 0;
        return isFar ? new Event(place.x, place.y, place.z, time) : new Event(0, 0, 0, time);
    }

    /** The event at the lens in a frame. */
    private PreciseEvent lensIn(FrameMotion motion) {
        if (motion == camera) {
            return PreciseEvent.of(lens);
        }
        PreciseEvent known = lensEvents.get(motion);
        if (known == null) {
            known = motion == null
                    ? law.sceneFromCamera(camera.velocity()).transform(PreciseEvent.of(lens))
                    : into(motion).transform(lensIn(motion.outer()).minus(motion.start()));
            lensEvents.put(motion, known);
        }
        return known;
    }

    private SpaceTimeTransformation into(FrameMotion motion) {
        return law.sceneFromCamera(motion.velocity()).inverse();
    }

    /** The way from one frame to another; null means the scene frame. */
    public FrameRoute route(FrameMotion from, FrameMotion to) {
        List<FrameMotion> outwards = FrameMotion.chain(from);
        List<FrameMotion> inwards = FrameMotion.chain(to);
        dropShared(outwards, inwards);
        List<FrameRoute.Step> route = new ArrayList<>();
        for (int i = outwards.size() - 1; i >= 0; i--) {
            route.add(step(outwards.get(i)).inverse());
        }
        inwards.forEach(motion -> route.add(step(motion)));
        return new FrameRoute(route);
    }

    /** How a second frame moves in a first one, by the laws of relativity; null means the scene frame. */
    public static RelativeMotion motion(FrameMotion first, FrameMotion second) {
        List<FrameMotion> toFirst = FrameMotion.chain(first);
        List<FrameMotion> toSecond = FrameMotion.chain(second);
        dropShared(toFirst, toSecond);
        return RelativeMotion.between(toFirst, toSecond);
    }

    /** Leaves out the frames that contain both ends. */
    private static void dropShared(List<FrameMotion> some, List<FrameMotion> others) {
        while (!some.isEmpty() && !others.isEmpty() && some.get(0) == others.get(0)) {
            some.remove(0);
            others.remove(0);
        }
    }

    /** The change from the frame around a frame to that frame. */
    private FrameRoute.Step step(FrameMotion motion) {
        FrameRoute.Step known = steps.get(motion);
        if (known != null) {
            return known;
        }
        Event outerOrigin = origin(motion.outer());
        Event innerOrigin = origin(motion);
        FrameRoute.Step step = outerOrigin.equals(Event.ORIGIN) && innerOrigin.equals(Event.ORIGIN)
                ? new FrameRoute.Step(motion.start(), into(motion), Event.ORIGIN)
                : new FrameRoute.Step(
                        lensIn(motion.outer()).minus(outerOrigin).rounded(),
                        into(motion),
                        lensIn(motion).minus(innerOrigin).rounded());
        steps.put(motion, step);
        return step;
    }
}
