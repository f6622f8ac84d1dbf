package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.fuzz.RandomStudio;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.search.RandomAims;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;

/** What every primitive of every object promises to rays. */
class PrimitiveContractTest {

    private static final Surface TILED = Tiling.DEFAULT;
    private static final int OBJECTS = 12;
    private static final int RAYS = 150;

    private final RandomAims aims = new RandomAims(7);

    static Stream<Class<?>> types() {
        return Descriptions.members(SceneObject.class).stream();
    }

    private static List<Primitive> primitives(Class<?> type) {
        List<Primitive> primitives = new ArrayList<>();
        for (int seed = 0; seed < OBJECTS; seed++) {
            List<Primitive> all = PrimitiveCollector.primitivesOf(RandomStudio.object(seed, type, TILED));
            primitives.addAll(all.subList(0, Math.min(4, all.size())));
        }
        return primitives;
    }

    @ParameterizedTest
    @MethodSource("types")
    void objectsKnowHowManyPrimitivesTheyBecome(Class<?> type) {
        for (int seed = 0; seed < OBJECTS; seed++) {
            SceneObject object = RandomStudio.object(seed, type, TILED);
            assertThat(PrimitiveCollector.primitivesOf(object)).hasSize((int) object.primitiveCount());
        }
    }

    @ParameterizedTest
    @MethodSource("types")
    void hitsKeepTheirPromises(Class<?> type) {
        int hits = 0;
        List<Primitive> primitives = primitives(type);
        for (Primitive primitive : primitives) {
            for (int i = 0; i < RAYS; i++) {
                Ray ray = aimed(primitive);
                double distance = primitive.distance(ray, Primitive.NO_HIT);
                if (distance == Primitive.NO_HIT) {
                    continue;
                }
                hits++;
                Hit hit = primitive.hit(ray, distance);
                liesOnTheRay(ray, distance, hit);
                respectsTheLimit(primitive, ray, distance);
                liesWithinTheBounds(primitive, hit);
                gradientsAreThoseOfTheCoordinates(primitive, ray, hit);
                otherRootFollows(primitive, ray, hit);
            }
        }
        assertThat(hits).isGreaterThanOrEqualTo(primitives.isEmpty() ? 0 : RAYS);
    }

    private Ray aimed(Primitive primitive) {
        Vector3d target = aims.placeIn(primitive);
        Vector3d origin = aims.vector(40);
        return ray(origin, target.sub(origin, new Vector3d()));
    }

    private static Ray ray(Vector3dc origin, Vector3dc direction) {
        Vector3d d = direction.normalize(new Vector3d());
        Ray ray = Ray.from(origin.x(), origin.y(), origin.z(), d.x, d.y, d.z, 5);
        ray.spread = 1e-3;
        return ray;
    }

    private static void liesOnTheRay(Ray ray, double distance, Hit hit) {
        assertThat(distance).isPositive();
        assertThat(place(hit).distance(at(ray, distance))).isLessThan(1e-9);
        assertThat(hit.time).isCloseTo(5 - distance, within(1e-12));
        assertThat(normal(hit).length()).isCloseTo(1, within(1e-12));
    }

    private static void respectsTheLimit(Primitive primitive, Ray ray, double distance) {
        assertThat(primitive.distance(ray, distance)).isEqualTo(distance);
        assertThat(primitive.distance(ray, distance * (1 - 1e-12))).isEqualTo(Primitive.NO_HIT);
    }

    private void liesWithinTheBounds(Primitive primitive, Hit hit) {
        Bounds bounds = primitive.bounds();
        if (bounds != null) {
            Bounds wide = bounds.widened();
            assertThat(hit.x).isBetween(wide.minX() - 1e-12, wide.maxX() + 1e-12);
            assertThat(hit.y).isBetween(wide.minY() - 1e-12, wide.maxY() + 1e-12);
            assertThat(hit.z).isBetween(wide.minZ() - 1e-12, wide.maxZ() + 1e-12);
        }
        Vector3d n = aims.vector(1);
        assertThat(primitive.minimumAlong(n.x, n.y, n.z)).isLessThanOrEqualTo(n.dot(place(hit)) + 1e-9);
        assertThat(primitive.conservativeMinimumAlong(n.x, n.y, n.z)).isLessThanOrEqualTo(n.dot(place(hit)));
    }

    private static void gradientsAreThoseOfTheCoordinates(Primitive primitive, Ray ray, Hit hit) {
        Ray beside = ray(new Vector3d(ray.x, ray.y, ray.z), direction(ray).add(2e-7, -1e-7, 1.5e-7));
        double distance = primitive.distance(beside, Primitive.NO_HIT);
        if (distance == Primitive.NO_HIT || Math.abs(hit.cosine(ray)) < 0.1) {
            return;
        }
        Hit other = primitive.hit(beside, distance);
        double du = other.coordinates.u() - hit.coordinates.u();
        double dv = other.coordinates.v() - hit.coordinates.v();
        if (other.part != hit.part || Math.abs(du) > 0.5) {
            return;
        }
        Vector3d step = place(other).sub(place(hit));
        Vector3d gradientU = new Vector3d(hit.coordinates.uX(), hit.coordinates.uY(), hit.coordinates.uZ());
        Vector3d gradientV = new Vector3d(hit.coordinates.vX(), hit.coordinates.vY(), hit.coordinates.vZ());
        double expectedU = gradientU.dot(step);
        double expectedV = gradientV.dot(step);
        assertThat(du).isCloseTo(expectedU, within(1e-3 * gradientU.length() * step.length() + 1e-12));
        assertThat(dv).isCloseTo(expectedV, within(1e-3 * gradientV.length() * step.length() + 1e-12));
    }

    /** A ray that goes on from a hit meets what a ray meets that starts a little beyond. */
    private static void otherRootFollows(Primitive primitive, Ray ray, Hit hit) {
        double step = 1e-5;
        Ray on = ray.straightOn(hit, 1);
        double next = primitive.distance(on, Primitive.NO_HIT);
        assertThat(next).isPositive();
        double beyond = primitive.distance(ray(at(ray, hit.distance + step), direction(ray)), Primitive.NO_HIT) + step;
        boolean both = next < Primitive.NO_HIT && beyond < Primitive.NO_HIT;
        if (both) {
            assertThat(next).isCloseTo(beyond, within(1e-6));
        } else if (next != beyond) {
            // only where the step jumps over the other root
            assertThat(next).isLessThan(2e-5);
        }
        double back = primitive.distance(ray.bent(hit, -ray.dx, -ray.dy, -ray.dz, 1), Primitive.NO_HIT);
        assertThat(back > hit.distance * (1 - 1e-9))
                .as("nothing before the first hit")
                .isTrue();
    }

    private static Vector3d place(Hit hit) {
        return new Vector3d(hit.x, hit.y, hit.z);
    }

    private static Vector3d normal(Hit hit) {
        return new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
    }

    private static Vector3d direction(Ray ray) {
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    private static Vector3d at(Ray ray, double distance) {
        return direction(ray).mul(distance).add(ray.x, ray.y, ray.z);
    }

    /** Closed objects against their inside, walked through in small steps: another way to find the first hit. */
    @Test
    void closedObjectsAreHitWhereTheInsideBegins() {
        Vector3d start = new Vector3d(1, -2, 3);
        Vector3d end = new Vector3d(-2, 1, 7);
        Vector3d axis = new Vector3d(end).sub(start);
        walkThrough(new Sphere("", start, 2.5, TILED), place -> place.distance(start) < 2.5);
        walkThrough(
                new Ellipsoid("", start, new Vector3d(2.5, 1, 0.6), TILED),
                place -> new Vector3d(place).sub(start).div(2.5, 1, 0.6).length() < 1);
        walkThrough(
                new Box("", new Vector3d(-1, 0, 2), new Vector3d(2, 1.5, 6), TILED),
                place -> place.x > -1 && place.x < 2 && place.y > 0 && place.y < 1.5 && place.z > 2 && place.z < 6);
        walkThrough(new Cylinder("", start, end, 1.5, true, TILED), place -> {
            double along = new Vector3d(place).sub(start).dot(axis) / axis.lengthSquared();
            return along > 0 && along < 1 && distanceFromLine(place, start, axis) < 1.5;
        });
        Vector3d unit = new Vector3d(axis).normalize();
        double rise = 2 - Math.sqrt(4 - 1.5 * 1.5);
        Vector3d centre = new Vector3d(start).fma(0.3 + rise - 2, unit);
        Vector3d hollow = new Vector3d(start).fma(-0.3 + rise - 2, unit);
        walkThrough(new Lens("", start, axis, 1.5, 0.6, 0.5, -0.5, TILED), place -> {
            double along = new Vector3d(place).sub(start).dot(unit);
            return distanceFromLine(place, start, axis) < 1.5
                    && place.distance(centre) < 2
                    && along > -0.3
                    && place.distance(hollow) > 2;
        });
        walkThrough(new Cone("", start, end, 2, true, TILED), place -> {
            double along = new Vector3d(place).sub(start).dot(axis) / axis.lengthSquared();
            return along > 0 && along < 1 && distanceFromLine(place, start, axis) < 2 * along;
        });
    }

    static Stream<Class<?>> closedTypes() {
        return SampleShapes.closed(new Vector3d(), 1, TILED).map(SampleShapes::shape);
    }

    /** A random closed object of such a type: of cylinders and cones those with ends. */
    private static SceneObject closed(long seed, Class<?> type) {
        return Stream.iterate(seed * 1000, next -> next + 1)
                .map(next -> RandomStudio.object(next, type, TILED))
                .filter(object -> !(object instanceof Cylinder cylinder && !cylinder.caps())
                        && !(object instanceof Cone cone && !cone.base()))
                .findFirst()
                .orElseThrow();
    }

    /** Whatever is among the closed samples must be closed. */
    @ParameterizedTest
    @MethodSource("closedTypes")
    void linesEnterAndLeaveClosedObjectsInTurn(Class<?> type) {
        int entered = 0;
        for (int seed = 0; seed < OBJECTS; seed++) {
            SceneObject object = closed(seed, type);
            List<Primitive> primitives = PrimitiveCollector.primitivesOf(object);
            for (int i = 0; i < RAYS; i++) {
                Primitive aim = primitives.get(i % primitives.size());
                Vector3d target = aims.placeIn(aim);
                Vector3d outside = aims.vector(1).normalize(1e3).add(target);
                entered += timesEntered(object, primitives, ray(outside, target.sub(outside)));
            }
        }
        assertThat(entered).as("lines that meet a %s", type.getSimpleName()).isGreaterThan(RAYS);
    }

    /** Follows a line from outside to its end. */
    private static int timesEntered(SceneObject object, List<Primitive> primitives, Ray line) {
        int entered = 0;
        boolean inside = false;
        Ray ray = line;
        for (Hit hit = nearest(primitives, ray); hit != null; hit = nearest(primitives, ray)) {
            assertThat(hit.cosine(ray) < 0)
                    .as("the normal points out where a line %s %s", inside ? "leaves" : "enters", object)
                    .isEqualTo(!inside);
            entered += inside ? 0 : 1;
            inside = !inside;
            ray = ray.straightOn(hit, 1);
        }
        assertThat(inside)
                .as("a line ends within %s; an open shape belongs to SampleShapes.open", object)
                .isFalse();
        return entered;
    }

    private static Hit nearest(List<Primitive> primitives, Ray ray) {
        Primitive nearest = null;
        double distance = Primitive.NO_HIT;
        for (Primitive primitive : primitives) {
            double candidate = primitive.distance(ray, distance);
            if (candidate < distance) {
                nearest = primitive;
                distance = candidate;
            }
        }
        return nearest == null ? null : nearest.hit(ray, distance);
    }

    private static double distanceFromLine(Vector3dc place, Vector3dc start, Vector3dc axis) {
        return place.sub(start, new Vector3d()).cross(axis).length() / axis.length();
    }

    private void walkThrough(SceneObject object, Predicate<Vector3d> inside) {
        List<Primitive> primitives = PrimitiveCollector.primitivesOf(object);
        double step = 0.005;
        for (int i = 0; i < 300; i++) {
            Vector3d origin = aims.vector(10);
            Ray ray = ray(origin, aims.vector(3).add(0, 0, 4).sub(origin));
            Hit hit = nearest(primitives, ray);
            double distance = hit == null ? Primitive.NO_HIT : hit.distance;
            boolean startsInside = inside.test(origin);
            double change = step;
            while (change < 40 && inside.test(at(ray, change)) == startsInside) {
                change += step;
            }
            if (distance < change - step) {
                // something thinner than a step, at an edge
                boolean near = inside.test(at(ray, distance + 1e-7)) != startsInside;
                assertThat(near).isTrue();
            } else {
                assertThat(distance).isBetween(change - step, change < 40 ? change : Primitive.NO_HIT);
            }
            if (hit != null) {
                assertThat(inside.test(normal(hit).mul(-1e-7).add(place(hit))))
                        .as("inwards")
                        .isTrue();
                assertThat(inside.test(normal(hit).mul(1e-7).add(place(hit))))
                        .as("outwards")
                        .isFalse();
            }
        }
    }
}
