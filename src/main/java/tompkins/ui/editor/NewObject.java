package tompkins.ui.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.LightSource;
import tompkins.light.PointLight;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.TriangleMesh;
import tompkins.surface.Tiling;

/**
 * Decides where new parts of a scene are placed: beside what is there already, and the first object on a floor. The
 * file of a mesh says where its corners are, often around the camera; it is placed ahead.
 */
final class NewObject {

    /** The distance from one object to the next, in widths of the new one. */
    private static final double STEP = 1.25;

    /** After this many places to either side, the object stays where it usually is. */
    private static final int MOST_STEPS = 50;

    /** Looking for room among more primitives, or for what is seen of them, would take too long. */
    private static final double MOST_PRIMITIVES = 100_000;

    /** From one lamp to the next. */
    private static final double LAMPS_APART = 200;

    /** Where objects usually are, ahead of a camera at the origin. */
    private static final Vector3dc AHEAD = Sphere.DEFAULT.centre();

    private NewObject() {}

    /** A new element of a list, of a type, in a place of its own if it has an end. */
    static Object of(Class<?> type, List<?> list) {
        Object standard = Descriptions.standard(type);
        if (standard instanceof TriangleMesh mesh) {
            return beside(ahead(mesh), list);
        }
        if (standard instanceof SceneObject object) {
            return beside(object, list);
        }
        return standard instanceof PointLight lamp ? beside(lamp, list) : standard;
    }

    private static SceneObject ahead(TriangleMesh mesh) {
        Placed ahead = Descriptions.with(Placed.DEFAULT, "translation", AHEAD);
        return Descriptions.with(Descriptions.with(ahead, "object", mesh), "description", mesh.description());
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
        Optional<Bounds> room = bounds(object);
        if (room.isEmpty()) {
            return object;
        }
        List<Bounds> taken = occupied(list);
        double step = STEP * (room.get().maxX() - room.get().minX());
        for (int i = 0; i <= 2 * MOST_STEPS; i++) {
            // to the right, to the left, farther to the right
            double right = step * (i % 2 == 1 ? (i + 1) / 2 : -i / 2);
            Vector3d way = new Vector3d(right, 0, 0);
            Bounds moved = room.get().moved(way);
            if (taken.stream().noneMatch(other -> overlap(moved, other))) {
                return right == 0 ? object : object.shifted(way);
            }
        }
        return object;
    }

    /** Whether nothing that has an end is where an object is. */
    static boolean isFree(SceneObject object, List<?> list) {
        return bounds(object)
                .map(room -> occupied(list).stream().noneMatch(other -> overlap(room, other)))
                .orElse(true);
    }

    /** The boxes around what has an end; none if there is too much of it. */
    private static List<Bounds> occupied(List<?> list) {
        List<SceneObject> objects = list.stream().map(SceneObject.class::cast).toList();
        return areTooMany(objects)
                ? List.of()
                : objects.stream()
                        .flatMap(each -> PrimitiveCollector.primitivesOf(each).stream())
                        .map(Primitive::bounds)
                        .filter(Objects::nonNull)
                        .toList();
    }

    /** Whether objects have more primitives than can be looked through. */
    static boolean areTooMany(List<SceneObject> objects) {
        return objects.stream().mapToDouble(SceneObject::primitiveCount).sum() > MOST_PRIMITIVES;
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

    private static boolean overlap(Bounds first, Bounds second) {
        return first.minX() <= second.maxX()
                && second.minX() <= first.maxX()
                && first.minY() <= second.maxY()
                && second.minY() <= first.maxY()
                && first.minZ() <= second.maxZ()
                && second.minZ() <= first.maxZ();
    }
}
