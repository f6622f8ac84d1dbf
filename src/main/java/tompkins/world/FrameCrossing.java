package tompkins.world;

import org.joml.Vector3d;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.PreciseEvent;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;

/**
 * The way of a ray from the camera frame into the scene frame, and where the coordinates of each frame begin.
 *
 * <p>A camera that has flown for a long time is far from the origin of the scene frame, and so is everything that it
 * sees: with coordinates of order 1e7 a double does not have enough digits for rods of radius 0.02. Then a frame is
 * described from an origin of its own near the camera (doubles, subtracted exactly from the objects), rays are
 * transformed relative to the lens, and the rest between the lens and that origin is added, worked out once with sixty
 * digits.
 */
public final class FrameCrossing {

    /**
     * If the camera is farther than this from the origin of a frame, in space or time, the frame gets an origin of its
     * own.
     */
    private static final double FAR = 1000;

    private final SpaceTimeTransformation sceneFromCamera;
    private final TransformationLaw law;
    private final Event lens;
    private final Event origin;

    /** Null if the scene keeps its own origin. */
    private final FrameStep step;

    /**
     * The crossing for rays that start near an event.
     *
     * @param law how coordinates change between the frames of the scene
     * @param lens an event at the lens, in the camera frame
     */
    public FrameCrossing(SpaceTimeTransformation sceneFromCamera, TransformationLaw law, Event lens) {
        this.sceneFromCamera = sceneFromCamera;
        this.law = law;
        this.lens = lens;
        Event inScene = sceneFromCamera.transform(lens);
        // a camera at rest has not moved away from what it sees
        boolean atRest = sceneFromCamera instanceof IdentityTransformation;
        Event far = origin(inScene);
        origin = atRest ? new Event(0, 0, 0, far.time()) : far;
        step = isOrigin(origin)
                ? null
                : new FrameStep(lens, sceneFromCamera, lensIn(null).minus(origin));
    }

    /** Where coordinates begin, for a lens at an event. */
    private static Event origin(Event lens) {
        Vector3d place = lens.position();
        boolean isFar = place.isFinite() && place.length() >= FAR;
        double time = Double.isFinite(lens.time()) && Math.abs(lens.time()) >= FAR ? lens.time() : 0;
        return isFar ? new Event(place.x, place.y, place.z, time) : new Event(0, 0, 0, time);
    }

    private static boolean isOrigin(Event event) {
        return event.equals(Event.ORIGIN);
    }

    /** The event at the lens in a frame; null means the scene frame. */
    private PreciseEvent lensIn(FrameMotion motion) {
        return motion == null
                ? sceneFromCamera.transform(PreciseEvent.of(lens))
                : law.sceneFromCamera(motion.velocity())
                        .inverse()
                        .transform(lensIn(motion.outer()).from(motion.start()));
    }

    /** The event at which the coordinates of a frame begin; null means the scene frame. */
    public Event origin(FrameMotion motion) {
        return motion == null ? origin : origin(lensIn(motion).rounded());
    }

    /**
     * The change from a frame to one that moves in it.
     *
     * @param outerOrigin where the coordinates of the outer frame begin
     * @param innerOrigin where those of the inner one begin
     */
    FrameStep stepInto(FrameMotion motion, Event outerOrigin, Event innerOrigin) {
        SpaceTimeTransformation into = law.sceneFromCamera(motion.velocity()).inverse();
        return isOrigin(outerOrigin) && isOrigin(innerOrigin)
                ? new FrameStep(motion.start(), into, Event.ORIGIN)
                : new FrameStep(
                        lensIn(motion.outer()).minus(outerOrigin),
                        into,
                        lensIn(motion).minus(innerOrigin));
    }

    /** The change from the camera frame to the scene frame. */
    FrameStep step() {
        return step == null ? new FrameStep(Event.ORIGIN, sceneFromCamera, Event.ORIGIN) : step;
    }

    /** The ray in the scene frame, in coordinates relative to {@link #origin()}. */
    public Ray cross(Ray ray) {
        return step == null ? sceneFromCamera.transform(ray) : step.transform(ray, Ray.blank());
    }

    /** An event of the camera frame in the scene frame, in coordinates relative to {@link #origin()}. */
    public Event cross(Event event) {
        return step().transform(event);
    }

    /** Takes each ray of a packet into the scene frame, as {@link #cross(Ray)}. */
    public void cross(RayPacket rays) {
        if (step == null) {
            sceneFromCamera.transform(rays);
        } else {
            step.transform(rays);
        }
    }

    /** The event at which the coordinates of the scene frame begin for the tracer; usually (0, 0, 0) at time 0. */
    public Event origin() {
        return origin;
    }
}
