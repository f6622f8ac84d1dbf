package tompkins.sceneobject;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.search.RandomAims;
import tompkins.surface.ColouredSurface;

/** Rays that meet a primitive only just: the next number beside them misses. Rounding alone decides about them. */
public final class EdgeRays {

    /** Halvings of an interval after which its ends are neighbouring numbers. */
    private static final int HALVINGS = 80;

    private final RandomAims aims;

    public EdgeRays(long seed) {
        aims = new RandomAims(seed);
    }

    /** Shapes of a size of about 1 round a place: with sides along the axes, where boxes fit without room, and not. */
    public List<Primitive> shapes(Vector3dc place) {
        List<SceneObject> objects = new ArrayList<>();
        ColouredSurface grey = ColouredSurface.DEFAULT;
        for (int axis = 0; axis < 3; axis++) {
            Vector3d u = new Vector3d().setComponent(axis, aims.mix(0.3, 1));
            Vector3d v = new Vector3d().setComponent((axis + 1) % 3, aims.mix(0.3, 1));
            Vector3d corner = place.add(aims.vector(0.3), new Vector3d());
            objects.add(new Parallelogram("wall " + axis, corner, u, v, grey));
            objects.add(new Triangle(
                    "triangle " + axis, corner, corner.add(u, new Vector3d()), corner.add(v, new Vector3d()), grey));
            objects.add(new Disc("disc " + axis, corner, u, aims.mix(0.1, 0.5), grey));
            objects.add(new Cylinder("rod " + axis, corner, corner.add(u, new Vector3d()), 0.01, true, grey));
        }
        objects.add(new Placed(
                "turned box",
                new Box("box", new Vector3d(), new Vector3d(0.3, 0.5, 1), grey),
                1,
                aims.vector(1),
                50,
                place));
        objects.add(new Sphere("ball", place, aims.mix(0.01, 1), grey));
        SampleShapes.all(place, aims.mix(0.1, 0.7), grey).forEach(objects::add);
        return objects.stream()
                .map(object -> PrimitiveCollector.primitivesOf(object).get(0))
                .toList();
    }

    /** A ray from a start that only just meets a primitive, or null if no ray was found that meets it. */
    public Ray to(Primitive primitive, Vector3dc start) {
        Predicate<Vector3dc> isMet = target -> hits(primitive, towards(start, target));
        Vector3d target = lastOf(isMet, primitive);
        return target == null ? null : towards(start, target);
    }

    /** A place in the box round a primitive for which a condition holds, next to one for which it does not; or null. */
    public Vector3d lastOf(Predicate<Vector3dc> condition, Primitive primitive) {
        Vector3d holds = aims.placeIn(primitive);
        for (int tries = 0; tries < 20 && !condition.test(holds); tries++) {
            holds = aims.placeIn(primitive);
        }
        Vector3d fails = aims.vector(1)
                .normalize(3 * primitive.bounds().halfDiagonal())
                .add(primitive.bounds().centre());
        if (!condition.test(holds) || condition.test(fails)) {
            return null;
        }
        for (int halving = 0; halving < HALVINGS; halving++) {
            Vector3d middle = holds.lerp(fails, 0.5, new Vector3d());
            (condition.test(middle) ? holds : fails).set(middle);
        }
        return holds;
    }

    /** A place at a distance from another. */
    public Vector3d placeAround(Vector3dc place, double distance) {
        return aims.vector(1).normalize(distance).add(place);
    }

    public static boolean hits(Primitive primitive, Ray ray) {
        return primitive.distance(ray, Primitive.NO_HIT) < Primitive.NO_HIT;
    }

    public static Ray towards(Vector3dc start, Vector3dc target) {
        Vector3d d = target.sub(start, new Vector3d()).normalize();
        return Ray.from(start.x(), start.y(), start.z(), d.x, d.y, d.z, 0);
    }
}
