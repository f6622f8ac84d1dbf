package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.Ellipsoid;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.sceneobject.TriangleMesh;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameTree;
import tompkins.spacetime.TransformationLaw;
import tompkins.surface.ColouredSurface;

/** No hit on what turns is missed or made up: against a walk along the ray in small steps. */
class RotatingHitsTest {

    private static final ColouredSurface DULL = ColouredSurface.DEFAULT;
    private static final Vector3dc CENTRE = new Vector3d(0.2, -0.1, 0.3);
    private static final Vector3dc AXIS = new Vector3d(1, 2, -2).div(3);
    private static final double SPEED = 0.45;
    private static final double PHASE = 50;
    private static final int RAYS = 250;
    private static final int STEPS = 1200;
    private static final double LENGTH = 6;

    private final SplittableRandom random = new SplittableRandom(11);

    static Stream<SceneObject> shapes() {
        Vector3d a = new Vector3d(0.3, 0.2, -0.4);
        Vector3d b = new Vector3d(-0.9, 0.7, 0.5);
        return Stream.of(
                new Sphere("ball", a, 0.6, DULL),
                new Ellipsoid("egg", a, new Vector3d(0.9, 0.3, 0.5), DULL),
                new Box("box", new Vector3d(-0.2, -0.8, -0.3), new Vector3d(0.9, 0.6, 0.2), DULL),
                new Cylinder("rod", a, b, 0.15, true, DULL),
                new Cylinder("tube", a, b, 0.4, false, DULL),
                new Cone("cone", a, b, 0.5, true, DULL),
                new Lens("lens", a, new Vector3d(1, 0.3, 0.2), 0.7, 0.6, 1.2, -0.9, DULL),
                new Disc("disc", a, new Vector3d(1, 0.3, 0.2), 0.8, DULL),
                new Disc("wheel", CENTRE, AXIS, 1.2, DULL),
                new Cylinder("axle", CENTRE, new Vector3d(CENTRE).add(AXIS), 0.5, true, DULL),
                new Parallelogram("sheet", a, new Vector3d(1, 0, 0.2), new Vector3d(0, 1, 0.4), DULL),
                new Triangle("triangle", a, b, new Vector3d(0.5, -0.9, 0.1), DULL),
                blind(),
                TriangleMesh.DEFAULT);
    }

    /** Slats and rods all round the axis, along it, with nothing between them. */
    private static SceneObject blind() {
        Vector3d out = new Vector3d(2, -2, -1).div(3);
        Vector3d right = new Vector3d(2, 1, 2).div(3);
        List<SceneObject> slats = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            double angle = 2 * Math.PI * i / 5;
            Vector3d radial = out.mul(Math.cos(angle), new Vector3d()).fma(Math.sin(angle), right);
            Vector3d along = new Vector3d(AXIS).cross(radial).mul(0.3);
            Vector3d corner = new Vector3d(CENTRE).fma(0.9, radial).fma(-0.5, AXIS);
            Vector3d up = new Vector3d(AXIS);
            slats.add(new Parallelogram("slat", corner, along, up, DULL));
            slats.add(new Cylinder("rod", corner, new Vector3d(corner).add(up), 0.05, true, DULL));
        }
        return new Group("blind", slats);
    }

    private static Rotating turning(double speed, SceneObject object) {
        return new Rotating("", CENTRE, AXIS, speed, PHASE, List.of(object));
    }

    private static ObjectTree tree(SceneObject object) {
        PrimitiveCollector collector =
                new PrimitiveCollector(point -> Event.ORIGIN, FrameTree.described(TransformationLaw.LORENTZ));
        object.addTo(collector, Placement.NONE);
        return new ObjectTree(collector.primitives(0));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void noHitIsMissedOrMadeUp(SceneObject object) {
        ObjectTree tree = tree(turning(SPEED, object));
        List<Primitive> described = PrimitiveCollector.primitivesOf(object);
        NearestHit nearest = new NearestHit(new RayCounts());
        int hits = 0;
        int different = 0;
        for (int i = 0; i < RAYS; i++) {
            Ray ray = ray();
            double expected = walk(described, ray);
            double found = tree.nearest(ray, LENGTH, nearest) ? nearest.distance() : Primitive.NO_HIT;
            hits += expected < Primitive.NO_HIT ? 1 : 0;
            different += expected == found || Math.abs(expected - found) < 2 * LENGTH / STEPS ? 0 : 1;
            if (found < Primitive.NO_HIT) {
                isOnTheSurface(described, ray, nearest.primitive().hit(ray, nearest.distance()));
            }
        }
        assertThat(hits).isGreaterThan(RAYS / 20);
        // only what is touched for less than a step may be walked past
        assertThat(different).isLessThanOrEqualTo(1);
    }

    /** Two rays along the axle meet a wheel at the same distance, the one after the other. */
    @Test
    void hitIsThatOfItsRay() {
        Disc wheel = new Disc("wheel", new Vector3d(0, 0, 2), new Vector3d(0, 0, 1), 1, DULL);
        ObjectTree tree = tree(new Rotating("", new Vector3d(), new Vector3d(0, 0, 1), SPEED, 0, List.of(wheel)));
        NearestHit nearest = new NearestHit(new RayCounts());
        Ray ray = Ray.from(0.5, 0.25, 0, 0, 0, 1, 0);

        tree.nearest(Ray.from(0, 0, 0, 0, 0, 1, 0), LENGTH, nearest);
        Hit hit = nearest.primitive().hit(ray, nearest.distance());

        assertThat(hit.distance).isEqualTo(2);
        assertThat(new double[] {hit.x, hit.y, hit.z}).containsExactly(0.5, 0.25, 2);
        assertThat(new double[] {hit.velocityX, hit.velocityY}).containsExactly(-0.25 * SPEED, 0.5 * SPEED);
    }

    private Ray ray() {
        Vector3d start = new Vector3d(CENTRE).add(random.nextDouble(-2, 2), random.nextDouble(-2, 2), -2.5);
        Vector3d aim = new Vector3d(CENTRE).add(inUnit(), inUnit(), inUnit());
        return EdgeRays.towards(start, aim).move(0, 0, 0, random.nextDouble(-20, 20));
    }

    private double inUnit() {
        return random.nextDouble(-1, 1);
    }

    /** Where the ray is, for an observer who turns, after a distance. */
    private static Vector3d described(Ray ray, double distance) {
        double angle = Math.toRadians(PHASE) + SPEED * (ray.time - distance);
        return new Vector3d(ray.dx, ray.dy, ray.dz)
                .mul(distance)
                .add(ray.x, ray.y, ray.z)
                .sub(CENTRE)
                .rotateAxis(-angle, AXIS.x(), AXIS.y(), AXIS.z())
                .add(CENTRE);
    }

    private static double walk(List<Primitive> primitives, Ray ray) {
        Vector3d from = described(ray, 0);
        for (int step = 1; step <= STEPS; step++) {
            Vector3d to = described(ray, step * LENGTH / STEPS);
            double length = to.distance(from);
            Ray piece = EdgeRays.towards(from, to);
            for (Primitive primitive : primitives) {
                if (primitive.distance(piece, length) < Primitive.NO_HIT) {
                    return (step - 0.5) * LENGTH / STEPS;
                }
            }
            from = to;
        }
        return Primitive.NO_HIT;
    }

    /** The place turned back lies on the object as it is described, and the normal is turned with it. */
    private static void isOnTheSurface(List<Primitive> primitives, Ray ray, Hit hit) {
        Vector3d at = described(ray, hit.distance);
        double angle = Math.toRadians(PHASE) + SPEED * hit.time;
        Vector3d normal =
                new Vector3d(hit.normalX, hit.normalY, hit.normalZ).rotateAxis(-angle, AXIS.x(), AXIS.y(), AXIS.z());
        Ray onto = Ray.from(
                at.x + 1e-6 * normal.x,
                at.y + 1e-6 * normal.y,
                at.z + 1e-6 * normal.z,
                -normal.x,
                -normal.y,
                -normal.z,
                0);
        double distance = primitives.stream()
                .mapToDouble(primitive -> primitive.distance(onto, 1))
                .min()
                .orElseThrow();
        assertThat(distance).isCloseTo(1e-6, within(1e-9));
    }

    /** What it comes by is thinner there than the steps in which numbers go. */
    @Test
    void flatThingsAreMetFromAfar() {
        Vector3d corner = new Vector3d(0.1, -0.1, 0);
        Vector3d u = new Vector3d(1, 0, 0);
        Vector3d v = new Vector3d(0, 1, 0);
        Parallelogram sheet = new Parallelogram("", corner, u, v, DULL);
        Rotating flat = new Rotating("", new Vector3d(), new Vector3d(0, 0, 1), 0.4, 0, List.of(sheet));
        NearestHit nearest = new NearestHit(new RayCounts());
        for (double away : new double[] {10, 1e4, 1e7}) {
            for (int i = 0; i < RAYS; i++) {
                double x = inUnit();
                double y = inUnit();
                // the light that arrives at this time left the plane at time 0, before anything has turned
                boolean expected = x > 0.1 && x < 1.1 && y > -0.1 && y < 0.9;
                Ray ray = Ray.from(x, y, -away, 0, 0, 1, away);
                assertThat(tree(flat).nearest(ray, nearest)).isEqualTo(expected);
            }
        }
    }

    /** In the plane of a face, and through a long tube, a ray stays near a face all the way. */
    @Test
    void raysAlongFacesAreQuick() {
        Vector3d up = new Vector3d(0, 0, 1);
        Box table = new Box("", new Vector3d(-1, -1, 0), new Vector3d(1, 1, 1), DULL);
        ObjectTree turntable = tree(new Rotating("", new Vector3d(), up, 0.4, 0, List.of(table)));
        double length = 1e6;
        SceneObject tube = new Cylinder("", new Vector3d(1e-6, 0, 0), new Vector3d(1e-6, 0, length), 1e-3, false, DULL);
        SceneObject end =
                new Parallelogram("", new Vector3d(-1, -1, length), new Vector3d(2, 0, 0), new Vector3d(0, 2, 0), DULL);
        ObjectTree peepShow = tree(new Rotating("", new Vector3d(), up, 1e-12, 0, List.of(tube, end)));
        NearestHit nearest = new NearestHit(new RayCounts());

        assertTimeoutPreemptively(Duration.ofMinutes(10), () -> {
            for (int i = 0; i < RAYS; i++) {
                double y = 0.9 * inUnit();
                double time = 20 * inUnit();
                assertThat(turntable.nearest(Ray.from(-3, y, 1e-9, 1, 0, 0, time), nearest))
                        .isTrue();
                double above = nearest.distance();
                assertThat(turntable.nearest(Ray.from(-3, y, 0, 1, 0, 0, time), nearest))
                        .isTrue();
                assertThat(nearest.distance()).isCloseTo(above, within(1e-8));

                assertThat(peepShow.nearest(Ray.from(0, 5e-4 * y, -1, 0, 0, 1, time), nearest))
                        .isTrue();
                assertThat(nearest.distance()).isCloseTo(length + 1, within(1e-8));
            }
        });
    }

    /** Light that almost stands still among what turns: nobody waits until all turns are searched. */
    @Test
    void aMillionTurnsAreNotWaitedFor() {
        ObjectTree tree = tree(turning(SPEED, new Group("", shapes().toList())));
        NearestHit nearest = new NearestHit(new RayCounts());

        assertTimeoutPreemptively(Duration.ofMinutes(10), () -> {
            for (int i = 0; i < RAYS / 50; i++) {
                Ray ray = ray();
                ray.setInFrame(ray, ray.x, ray.y, ray.z, ray.dx, ray.dy, ray.dz, ray.time, 1e8, 1, 1);
                tree.nearest(ray, nearest);
            }
        });
    }

    /** Where it does not turn, it is placed: bit for bit. */
    @Test
    void withoutSpeedItIsPlaced() {
        Rotating still = new Rotating("", new Vector3d(), AXIS, 0, PHASE, shapes().toList());
        List<Primitive> placed = PrimitiveCollector.primitivesOf(
                new Placed("", new Group("", shapes().toList()), 1, AXIS, PHASE, new Vector3d()));
        List<Primitive> turned = PrimitiveCollector.primitivesOf(still);

        assertThat(turned).hasSameSizeAs(placed);
        for (int i = 0; i < placed.size(); i++) {
            Ray ray = ray();
            assertThat(turned.get(i).distance(ray, Primitive.NO_HIT))
                    .isEqualTo(placed.get(i).distance(ray, Primitive.NO_HIT));
            assertThat(turned.get(i).bounds()).isEqualTo(placed.get(i).bounds());
        }
    }
}
