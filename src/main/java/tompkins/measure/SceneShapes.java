package tompkins.measure;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Described;
import tompkins.primitive.Primitive;
import tompkins.primitive.SpherePrimitive;
import tompkins.sceneobject.FrameObjects;
import tompkins.spacetime.FrameMotion;
import tompkins.surface.GalileoWindow;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;

/**
 * The shapes of a scene for which overlays are drawn: its first spheres, rods and objects.
 *
 * @param spheres spheres
 * @param rods axes of rods
 * @param objects bounded objects
 * @param complete whether these are all
 * @param turnsRays whether the scene holds mirrors, glass or windows, in which objects are seen elsewhere
 */
public record SceneShapes(
        List<Ball> spheres, List<Rod> rods, List<Thing> objects, boolean complete, boolean turnsRays) {

    /** The most of each. */
    public static final int MOST = 400;

    /** The most primitives that are looked at. */
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
     * The axis of a rod.
     *
     * @param motion how its frame moves; null for the scene frame
     * @param start one end in its frame
     * @param end the other end
     */
    public record Rod(FrameMotion motion, Vector3dc start, Vector3dc end) {}

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
    public static SceneShapes of(List<FrameObjects> frames) {
        Collector collector = new Collector();
        frames.forEach(collector::add);
        return collector.shapes();
    }

    private static final class Collector {

        private final List<Ball> spheres = new ArrayList<>();
        private final List<Rod> rods = new ArrayList<>();
        private final List<Thing> objects = new ArrayList<>();
        private int looked;
        private boolean complete = true;
        private boolean turnsRays;

        void add(FrameObjects frame) {
            Vector3d origin = frame.origin().position();
            IdentityHashMap<Described, Integer> places = new IdentityHashMap<>();
            for (Primitive primitive : frame.primitives()) {
                if (looked++ >= MOST_PRIMITIVES) {
                    complete = false;
                    return;
                }
                turnsRays |= primitive.surface().parts().anyMatch(Collector::turns);
                add(frame.motion(), origin, primitive);
                Bounds bounds = primitive.bounds();
                if (bounds != null && bounds.centre().isFinite()) {
                    addBounds(frame.motion(), primitive.object(), bounds.moved(origin), places);
                }
            }
        }

        private void add(FrameMotion motion, Vector3d origin, Primitive primitive) {
            if (primitive instanceof SpherePrimitive sphere && hasRoom(spheres)) {
                spheres.add(new Ball(motion, sphere.centre().add(origin), sphere.radius()));
            } else if (primitive instanceof CylinderPrimitive rod && hasRoom(rods)) {
                rods.add(new Rod(motion, rod.start().add(origin), rod.end().add(origin)));
            }
        }

        private void addBounds(FrameMotion motion, Described object, Bounds bounds, Map<Described, Integer> places) {
            Integer known = places.get(object);
            if (known != null) {
                Thing thing = objects.get(known);
                objects.set(known, new Thing(motion, thing.name, thing.bounds.with(bounds)));
            } else if (hasRoom(objects)) {
                places.put(object, objects.size());
                objects.add(new Thing(motion, object.description(), bounds));
            }
        }

        private boolean hasRoom(List<?> shapes) {
            boolean room = shapes.size() < MOST;
            complete &= room;
            return room;
        }

        private static boolean turns(Surface surface) {
            return surface instanceof Mirror
                    || surface instanceof Refractive
                    || surface instanceof LorentzWindow
                    || surface instanceof GalileoWindow;
        }

        SceneShapes shapes() {
            return new SceneShapes(List.copyOf(spheres), List.copyOf(rods), List.copyOf(objects), complete, turnsRays);
        }
    }
}
