package tompkins.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.RestingLight;
import tompkins.primitive.Bounds;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.search.LampShadows;
import tompkins.search.LampTrack;
import tompkins.search.ObjectTree;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.FrameRoute;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.studio.Studio;

/**
 * The scene, ready to be met by rays: for each velocity in it an inertial frame with the primitives that rest there in
 * a tree; the lamps, each in its frame, and what each lamp sees of what rests with it. None of it depends on the
 * camera, unless the scene holds image points or the camera is far away; a film in which only the camera changes uses
 * one for all its pictures.
 */
public final class World {

    /** The most lamps that get a light buffer, which takes milliseconds to make; for further lamps the tree is used. */
    private static final int MOST_BUFFERS = 16;

    /**
     * The most primitives that all lamps with buffers see together: a million take 30 MB and half a second for each
     * lamp. Lamps that pass may see the same number again.
     */
    private static final int MOST_SEEN = 2_000_000;

    private final List<SceneObject> described;
    private final List<LightSource> describedLights;
    private final TransformationLaw law;
    private final boolean followsCamera;
    private final List<InertialFrame> frames;

    private final List<Lamp> lamps;

    /**
     * Prepares the scene of a studio.
     *
     * @param tree says where the coordinates of each frame begin
     * @param imagePoints where the camera photographs the points that move with it
     * @throws tompkins.property.InvalidPropertyException if an object is too large, too small or too fast to work with
     */
    public World(Studio studio, FrameTree tree, Function<Vector3dc, Event> imagePoints) {
        described = studio.scene();
        describedLights = studio.lights();
        law = studio.transformation();
        boolean[] asked = new boolean[1];
        PrimitiveCollector collector = new PrimitiveCollector(
                point -> {
                    asked[0] = true;
                    return imagePoints.apply(point);
                },
                tree);
        Placement placement = new Placement(
                1, new Matrix3d(), new Vector3d(), tree.origin(null).position());
        collector.add("scene", described, placement);
        followsCamera = asked[0];
        List<Lamp> unprepared = new ArrayList<>();
        for (int i = 0; i < describedLights.size(); i++) {
            try {
                add(describedLights.get(i), collector, placement, unprepared);
            } catch (InvalidPropertyException tooFast) {
                throw new InvalidPropertyException("lights[" + i + "]", tooFast);
            }
        }
        // trees hold copies, so that what was collected can be forgotten
        frames = IntStream.range(0, collector.motions().size())
                .mapToObj(frame -> new InertialFrame(
                        collector.motions().get(frame),
                        tree.origin(collector.motions().get(frame)),
                        new ObjectTree(collector.primitives(frame))))
                .toList();
        lamps = prepared(unprepared, routes(tree));
    }

    private static void add(LightSource source, PrimitiveCollector collector, Placement placement, List<Lamp> lamps) {
        if (source instanceof MovingLights moving) {
            collector.addMoving(
                    moving.velocity(),
                    moving.place(),
                    0,
                    placement,
                    inner -> moving.objects().forEach(light -> add(light, collector, inner, lamps)));
        } else if (source instanceof RestingLight light) {
            lamps.add(new Lamp(
                    light.shifted(placement.point(new Vector3d())),
                    collector.frame(),
                    collector.rest().properTimeZero().time()));
        }
    }

    private List<Lamp> prepared(List<Lamp> unprepared, FrameRoutes routes) {
        List<Lamp> prepared = new ArrayList<>();
        AtomicLong left = new AtomicLong(MOST_SEEN);
        int places = 0;
        try {
            for (Lamp lamp : unprepared) {
                ObjectTree seen = objects(lamp.frame());
                boolean hasTracks = lamp.position() != null && places++ < MOST_BUFFERS;
                boolean hasBuffer = hasTracks && places <= MOST_SEEN / Math.max(1, seen.size());
                prepared.add(new Lamp(
                        lamp.light(),
                        lamp.frame(),
                        lamp.properTimeZero(),
                        hasBuffer ? LampShadows.of(lamp.position(), seen) : null,
                        hasTracks ? tracks(lamp, routes, left) : List.of()));
            }
        } catch (ArithmeticException beyondNumbers) {
            throw PrimitiveCollector.refusal("scene", "larger");
        }
        return List.copyOf(prepared);
    }

    /** The way of a lamp past what rests in each frame other than its own. */
    private List<LampTrack> tracks(Lamp lamp, FrameRoutes routes, AtomicLong left) {
        return IntStream.range(0, frames.size())
                .mapToObj(frame -> frame == lamp.frame()
                        ? null
                        : LampTrack.of(
                                place(routes, lamp, frame, 0), place(routes, lamp, frame, 1), objects(frame), left))
                .toList();
    }

    private static Vector3dc place(FrameRoutes routes, Lamp lamp, int frame, double time) {
        Vector3dc place = lamp.position();
        return routes.route(lamp.frame(), frame)
                .transform(new Event(place.x(), place.y(), place.z(), time))
                .position();
    }

    /** Whether the same would be prepared for a studio, whatever its camera is. */
    public boolean isOf(Studio studio, FrameTree tree) {
        return !followsCamera
                && described == studio.scene()
                && describedLights == studio.lights()
                && (law == studio.transformation() || !moves() && !studio.hasMotion())
                && frames.stream().allMatch(frame -> tree.origin(frame.motion()).equals(frame.origin()));
    }

    /** Whether the scene holds image points, and so depends on the camera. */
    public boolean followsCamera() {
        return followsCamera;
    }

    /** Whether something moves or turns. */
    public boolean moves() {
        return frames.size() > 1 || objects(0).rotates();
    }

    /** What rests in each frame, the scene frame first; the same list for all plans that share a scene. */
    public List<InertialFrame> frames() {
        return frames;
    }

    /** The primitives that rest in a frame. */
    public ObjectTree objects(int frame) {
        return frames.get(frame).objects();
    }

    /** What rays and light can meet, for one thread. */
    public Surroundings surroundings(FrameRoutes routes, TransformationLaw lawOfLight, RayCounts counts) {
        ObjectTree[] trees = frames.stream().map(InertialFrame::objects).toArray(ObjectTree[]::new);
        return new Surroundings(trees, lamps, routes, lawOfLight, counts);
    }

    /**
     * Boxes around the first bounded objects, in the scene frame, where they are at a time of it; boxes of moving
     * objects hold the corners of their boxes at rest.
     */
    public List<Bounds> bounds(double sceneTime, int most) {
        return frames.stream()
                .flatMap(frame -> bounds(frame, sceneTime))
                .limit(most)
                .toList();
    }

    private Stream<Bounds> bounds(InertialFrame frame, double sceneTime) {
        return frame.objects().primitives().stream()
                .map(Primitive::allBounds)
                .filter(Objects::nonNull)
                .map(box -> inScene(box.moved(frame.origin().position()), frame.motion(), sceneTime));
    }

    private Bounds inScene(Bounds box, FrameMotion motion, double sceneTime) {
        if (motion == null) {
            return box;
        }
        FrameRoute toScene = motion.toScene(law);
        return Bounds.around(Stream.of(box.corners())
                .map(corner -> toScene.place(corner, sceneTime))
                .toArray(Vector3dc[]::new));
    }

    /** Whether there are primitives in any frame. */
    public boolean hasObjects() {
        return frames.stream().anyMatch(frame -> frame.objects().size() > 0);
    }

    /** All light sources, each at rest in its frame, in the coordinates in which the tracer works. */
    public List<RestingLight> lights() {
        return lamps.stream().map(Lamp::light).toList();
    }

    /** The same lights, each with its frame. */
    public List<Lamp> lamps() {
        return lamps;
    }

    /** The ways between the frames. */
    public FrameRoutes routes(FrameTree tree) {
        return new FrameRoutes(frames.stream().map(InertialFrame::motion).toList(), tree);
    }
}
