package tompkins.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.BoxPrimitive;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Described;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.Primitive;
import tompkins.primitive.Rotation;
import tompkins.primitive.SpherePrimitive;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.TriangleMesh;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.surface.Continuation;
import tompkins.world.InertialFrame;

/**
 * The shapes of a scene for which overlays are drawn: its first spheres, lines and objects. What turns is an object
 * with the box of all that it comes by.
 *
 * @param spheres spheres, without those that turn about an axis beside their centres
 * @param lines axes of rods, edges of boxes and of flat pieces, and the rims of discs, lenses and cones; not those of
 *     meshes
 * @param objects bounded objects
 * @param complete whether these are all
 * @param turnsRays whether the scene holds mirrors, glass or windows, in which objects are seen elsewhere
 */
public record SceneShapes(
        List<Ball> spheres, List<Line> lines, List<Thing> objects, boolean complete, boolean turnsRays) {

    /** The most of each; a box has twelve lines. */
    private static final int MOST = 400;

    private static final int MOST_LINES = 12 * MOST;

    /** The most primitives that are looked at: the first of the scene. */
    private static final int MOST_PRIMITIVES = 100_000;

    /**
     * A sphere.
     *
     * @param motion how its frame moves; null for the scene frame
     * @param centre centre in its frame
     * @param radius radius
     */
    public record Ball(FrameMotion motion, Vector3dc centre, double radius) {}

    /**
     * A line with two ends, or a circle.
     *
     * @param motion how its frame moves; null for the scene frame
     * @param turn how it turns there; null if it rests
     * @param places its points in its frame, before anything turned, from one end at 0 to the other at 1
     */
    public record Line(FrameMotion motion, Turn turn, DoubleFunction<Vector3d> places) {}

    /**
     * How something turns in its frame.
     *
     * @param rotation the rotation, in coordinates of its own
     * @param origin the event of the frame at which these begin
     */
    public record Turn(Rotation rotation, Event origin) {

        /** Where a point, given before anything turned, is at a time of the frame. */
        Vector3d place(Vector3dc point, double time) {
            Vector3d middle = foot(point);
            Vector3d aside = point.sub(middle, new Vector3d());
            return rotation.turned(aside, rotation.angle(time - origin.time())).add(middle);
        }

        /** The middle of the circle on which a point runs. */
        Vector3d foot(Vector3dc point) {
            Vector3d centre = rotation.centre().add(origin.position(), new Vector3d());
            double along = point.sub(centre, new Vector3d()).dot(rotation.axis());
            return centre.fma(along, rotation.axis());
        }
    }

    /**
     * An object.
     *
     * @param motion how its frame moves; null for the scene frame
     * @param name its name
     * @param bounds the box around it in its frame
     */
    public record Thing(FrameMotion motion, String name, Bounds bounds) {

        /** Its middle. */
        public Vector3d middle() {
            return bounds.centre();
        }
    }

    /** The shapes of what rests in some frames. */
    public static SceneShapes of(List<InertialFrame> frames) {
        Collector collector = new Collector();
        frames.forEach(collector::add);
        return collector.shapes();
    }

    private static final class Collector {

        private final List<Ball> spheres = new ArrayList<>();
        private final List<Line> lines = new ArrayList<>();
        private final List<Thing> objects = new ArrayList<>();
        private boolean complete = true;
        private boolean turnsRays;

        void add(InertialFrame frame) {
            Vector3d origin = frame.origin().position();
            IdentityHashMap<Described, Integer> places = new IdentityHashMap<>();
            List<Primitive> all = frame.objects().primitives();
            List<Primitive> first = all.stream()
                    .filter(primitive -> primitive.order() < MOST_PRIMITIVES)
                    .sorted(Comparator.comparingInt(Primitive::order))
                    .toList();
            complete &= first.size() == all.size();
            for (Primitive primitive : first) {
                turnsRays |= primitive.surface().continuation() == Continuation.TURNED;
                Rotation rotation = primitive.restFrame().rotation();
                add(frame.motion(), rotation == null ? null : new Turn(rotation, frame.origin()), origin, primitive);
                Bounds bounds = primitive.allBounds();
                if (bounds != null && bounds.centre().isFinite()) {
                    addBounds(frame.motion(), primitive.object(), bounds.moved(origin), places);
                }
            }
        }

        private void add(FrameMotion motion, Turn turn, Vector3d origin, Primitive primitive) {
            if (primitive instanceof SpherePrimitive sphere) {
                boolean stays = turn == null || turn.rotation.isOnAxis(sphere.centre());
                if (stays && hasRoom(spheres, MOST)) {
                    spheres.add(new Ball(motion, sphere.centre().add(origin), sphere.radius()));
                }
            } else if (primitive instanceof CylinderPrimitive rod) {
                addLine(motion, turn, origin, rod.start(), rod.end());
            } else if (primitive instanceof BoxPrimitive box) {
                addEdges(motion, turn, origin, box.corners());
            } else if (primitive instanceof FlatPrimitive piece && !(piece.object() instanceof TriangleMesh)) {
                List<Vector3d> corners = piece.corners();
                for (int i = 0; i < corners.size(); i++) {
                    addLine(motion, turn, origin, corners.get(i), corners.get((i + 1) % corners.size()));
                }
            }
            List<Vector3d> rim = primitive.rim();
            // rods have their axes instead, and cones the edge of their mantle
            boolean isEnd = primitive instanceof FlatPrimitive && !(primitive.object() instanceof Disc);
            if (!rim.isEmpty() && !isEnd) {
                Vector3d middle = new Vector3d(origin).add(rim.get(0));
                addLine(motion, turn, part -> {
                    double angle = 2 * Math.PI * part;
                    return new Vector3d(middle).fma(Math.cos(angle), rim.get(1)).fma(Math.sin(angle), rim.get(2));
                });
            }
        }

        /** Two corners of a box whose numbers differ by one bit have an edge between them. */
        private void addEdges(FrameMotion motion, Turn turn, Vector3dc origin, List<Vector3d> corners) {
            for (int corner = 0; corner < corners.size(); corner++) {
                for (int bit = 1; bit < corners.size(); bit *= 2) {
                    if ((corner & bit) == 0) {
                        addLine(motion, turn, origin, corners.get(corner), corners.get(corner | bit));
                    }
                }
            }
        }

        private void addLine(FrameMotion motion, Turn turn, Vector3dc origin, Vector3dc start, Vector3dc end) {
            Vector3d from = start.add(origin, new Vector3d());
            Vector3d to = end.add(origin, new Vector3d());
            addLine(motion, turn, part -> from.lerp(to, part, new Vector3d()));
        }

        private void addLine(FrameMotion motion, Turn turn, DoubleFunction<Vector3d> places) {
            if (hasRoom(lines, MOST_LINES)) {
                lines.add(new Line(motion, turn, places));
            }
        }

        private void addBounds(FrameMotion motion, Described object, Bounds bounds, Map<Described, Integer> places) {
            Integer known = places.get(object);
            if (known != null) {
                Thing thing = objects.get(known);
                objects.set(known, new Thing(motion, thing.name, thing.bounds.with(bounds)));
            } else if (hasRoom(objects, MOST)) {
                places.put(object, objects.size());
                objects.add(new Thing(motion, object.description(), bounds));
            }
        }

        private boolean hasRoom(List<?> shapes, int most) {
            boolean room = shapes.size() < most;
            complete &= room;
            return room;
        }

        SceneShapes shapes() {
            return new SceneShapes(List.copyOf(spheres), List.copyOf(lines), List.copyOf(objects), complete, turnsRays);
        }
    }
}
