package tompkins.ui.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.LightSource;
import tompkins.light.PointLight;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.surface.Tiling;

/** Decides where new parts of a scene are placed: beside what is there already, and the first object on a floor. */
final class NewObject {

    /** The components of objects that say where they are, and not how large or how turned. */
    private static final Set<String> PLACES = Set.of(
            "centre",
            "from",
            "to",
            "tip",
            "baseCentre",
            "start",
            "end",
            "corner",
            "first",
            "second",
            "third",
            "translation",
            "place");

    /** The distance from one object to the next, in widths of the new one. */
    private static final double STEP = 1.25;

    /** After this many places to either side, the object stays where it usually is. */
    private static final int MOST_STEPS = 50;

    /** Looking for room among more primitives would take too long. */
    private static final double MOST_PRIMITIVES = 100_000;

    /** From one lamp to the next. */
    private static final double LAMPS_APART = 200;

    private NewObject() {}

    /** A new element of a list, of a type, in a place of its own. */
    static Object of(Class<?> type, List<?> list) {
        Object standard = Descriptions.standard(type);
        if (standard instanceof SceneObject object) {
            return beside(object, list);
        }
        return standard instanceof PointLight lamp ? beside(lamp, list) : standard;
    }

    private static LightSource beside(PointLight lamp, List<?> list) {
        PointLight placed = lamp;
        while (isTaken(placed.position(), list)) {
            Vector3d next = new Vector3d(placed.position()).add(-LAMPS_APART, 0, 0);
            placed = Descriptions.with(placed, "position", next);
        }
        return placed;
    }

    private static boolean isTaken(Vector3dc place, List<?> list) {
        return list.stream()
                .anyMatch(each ->
                        each instanceof PointLight other && other.position().equals(place));
    }

    private static SceneObject beside(SceneObject object, List<?> list) {
        List<SceneObject> others = list.stream().map(SceneObject.class::cast).toList();
        double primitives =
                others.stream().mapToDouble(SceneObject::primitiveCount).sum();
        Optional<Bounds> room = bounds(object);
        if (room.isEmpty() || primitives > MOST_PRIMITIVES) {
            return object;
        }
        List<Bounds> taken = others.stream()
                .flatMap(other -> PrimitiveCollector.primitivesOf(other).stream())
                .map(Primitive::bounds)
                .filter(Objects::nonNull)
                .toList();
        double step = STEP * (room.get().maxX() - room.get().minX());
        for (int i = 0; i <= 2 * MOST_STEPS; i++) {
            // to the right, to the left, farther to the right
            double right = step * (i % 2 == 1 ? (i + 1) / 2 : -i / 2);
            Bounds moved = moved(room.get(), right);
            if (taken.stream().noneMatch(other -> overlap(moved, other))) {
                return right == 0 ? object : moved(object, right);
            }
        }
        return object;
    }

    /** The floor beneath a first object; empty if the object has no place, or is endless itself. */
    static Optional<SceneObject> floorBeneath(Object first) {
        return first instanceof SceneObject object
                ? bounds(object)
                        .map(bounds -> new Plane(
                                "floor", new Vector3d(0, bounds.minY(), 0), new Vector3d(0, 1, 0), Tiling.DEFAULT))
                : Optional.empty();
    }

    /** The box around an object; empty if it is endless or empty. */
    private static Optional<Bounds> bounds(SceneObject object) {
        List<Bounds> parts = new ArrayList<>();
        PrimitiveCollector.primitivesOf(object).forEach(primitive -> parts.add(primitive.bounds()));
        return parts.contains(null) ? Optional.empty() : parts.stream().reduce(Bounds::with);
    }

    private static Bounds moved(Bounds bounds, double right) {
        return new Bounds(
                bounds.minX() + right,
                bounds.minY(),
                bounds.minZ(),
                bounds.maxX() + right,
                bounds.maxY(),
                bounds.maxZ());
    }

    private static SceneObject moved(SceneObject object, double right) {
        return Descriptions.changed(
                object,
                (name, value) -> PLACES.contains(name) ? new Vector3d((Vector3dc) value).add(right, 0, 0) : value);
    }

    private static boolean overlap(Bounds first, Bounds second) {
        return first.minX() <= second.maxX()
                && second.minX() <= first.maxX()
                && first.minY() <= second.maxY()
                && second.minY() <= first.maxY()
                && first.minZ() <= second.maxZ()
                && second.minZ() <= first.maxZ();
    }
}
