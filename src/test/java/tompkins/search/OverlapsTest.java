package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.TestRun;
import tompkins.fuzz.RandomStudio;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.surface.ColouredSurface;

/**
 * What tells rays from primitives without testing them allows for rounding: it never tells a ray from what the ray only
 * just meets, and tells it from what it only just misses.
 */
class OverlapsTest {

    private static final int ROUNDS = TestRun.cases(5, 12);

    /** Shapes of a size of 1, so far from the origin, and starts so far from them, or (0) near the origin. */
    @ParameterizedTest
    @CsvSource({
        "0, 2",
        "0, 1e3",
        "0, 1e5",
        "0, 1e7",
        "1, 30",
        "1, 1e5",
        "1e3, 2",
        "1e3, 1e7",
        "1e6, 30",
        "1e6, 1e3",
        "1e6, 1e7",
        "1e8, 2",
        "1e8, 1e3",
        "1e8, 1e7",
        "1e2, 0",
        "1e4, 0",
        "1e6, 0",
        "1e8, 0"
    })
    void whatIsOnlyJustMetIsKept(double far, double distance) {
        EdgeRays edges = new EdgeRays(7);
        int kept = 0;
        for (int round = 0; round < ROUNDS; round++) {
            Vector3d place = edges.placeAround(new Vector3d(), far);
            for (Primitive primitive : edges.shapes(place)) {
                Vector3d start =
                        distance > 0 ? edges.placeAround(place, distance) : edges.placeAround(new Vector3d(), 0.1);
                kept += mustKeep(primitive, edges.to(primitive, start));
            }
        }
        assertThat(kept).isGreaterThan(50);
    }

    /** Those without bounds, planes, have no edges. */
    @Test
    void everyKindOfPrimitiveWithBoundsIsTried() {
        Set<Class<?>> tried = new EdgeRays(7)
                .shapes(new Vector3d()).stream().map(Primitive::getClass).collect(Collectors.toSet());
        for (Class<?> type : Descriptions.members(SceneObject.class)) {
            for (Primitive primitive :
                    PrimitiveCollector.primitivesOf(RandomStudio.object(1, type, ColouredSurface.DEFAULT))) {
                assertThat(primitive.bounds() == null || tried.contains(primitive.getClass()))
                        .as("add a %s to EdgeRays.shapes", type.getSimpleName())
                        .isTrue();
            }
        }
    }

    /** Whether there is a ray that was looked for, 0 or 1. */
    private static int mustKeep(Primitive primitive, Ray ray) {
        if (ray == null) {
            return 0;
        }
        String name = primitive.description();
        double distance = primitive.distance(ray, Primitive.NO_HIT);
        TreeNode node = node(primitive);
        // as if something else had been found at the same distance, which may be listed later
        assertThat(entry(node, ray, distance)).as(name).isLessThanOrEqualTo(distance);

        RayPacket block = block(ray);
        PacketFrustum bundle = bundle(block);
        assertThat(bundle.misses(node)).as(name).isFalse();
        assertThat(bundle.misses(primitive)).as(name).isFalse();
        assertThat(bundle.leastDistance(node)).as(name).isLessThanOrEqualTo(distance);

        mustOverlap(primitive, block);
        mustOverlap(primitive, block(ray, Ray.from(ray.x + 1, ray.y, ray.z, ray.dx, ray.dy, ray.dz, 0)));
        return 1;
    }

    /** The first ray of a block, of which all start at one place or several. */
    private static void mustOverlap(Primitive primitive, RayPacket block) {
        PacketFrustum bundle = bundle(block);
        double[] overlaps = new double[block.count()];
        if (primitive.overlaps(block, bundle.hasOneStart(), bundle.farthest(), overlaps)) {
            assertThat(overlaps[0]).as(primitive.description()).isGreaterThanOrEqualTo(0);
        }
    }

    /** Shapes so far from the origin, lamps so far from them, and places so many times as far behind them. */
    @ParameterizedTest
    @CsvSource({
        "0, 2, 1.7",
        "0, 30, 1e3",
        "0, 2, 1e6",
        "0, 2, 1e8",
        "1e3, 2, 1.7",
        "1e3, 30, 1e6",
        "1e6, 2, 1e2",
        "1e7, 30, 2"
    })
    void whatOnlyJustThrowsAShadowIsKept(double far, double distance, double behind) {
        EdgeRays edges = new EdgeRays(13);
        int shadows = 0;
        for (int round = 0; round < ROUNDS; round++) {
            Vector3d place = edges.placeAround(new Vector3d(), far);
            for (Primitive primitive : edges.shapes(place)) {
                shadows += mustKeepShadow(
                        edges, primitive, List.of(primitive), edges.placeAround(place, distance), behind);
            }
        }
        assertThat(shadows).isGreaterThan(50);
    }

    /** The edge of a rectangle in the middle of what a lamp sees: there two cells of its grid meet. */
    @ParameterizedTest
    @CsvSource({"100, 2", "1, 1e6"})
    void whatEndsWhereTwoCellsOfALampMeetThrowsItsShadow(double far, double behind) {
        EdgeRays edges = new EdgeRays(17);
        int shadows = 0;
        for (int round = 0; round < 300; round++) {
            Vector3d place = edges.placeAround(new Vector3d(), far);
            List<Primitive> walls = IntStream.of(-10, 0, 9)
                    .mapToObj(tenth -> wall(place.add(tenth / 10.0, -1, 0, new Vector3d())))
                    .toList();
            Vector3d lamp = place.add(0, 0, -2 - 0.01 * round, new Vector3d());
            shadows += mustKeepShadow(edges, walls.get(1), walls, lamp, behind);
        }
        assertThat(shadows).isGreaterThan(50);
    }

    private static Primitive wall(Vector3dc corner) {
        return only(new Parallelogram(
                "wall", corner, new Vector3d(0.1, 0, 0), new Vector3d(0, 2, 0), ColouredSurface.DEFAULT));
    }

    /** A hair right before a lamp is a band that has no room to spare. */
    @ParameterizedTest
    @CsvSource({"0, 1e6, 1e-8", "1e8, 2, 1e-7"})
    void hairBeforeALampThrowsItsShadow(double far, double behind, double radius) {
        EdgeRays edges = new EdgeRays(19);
        int shadows = 0;
        for (int round = 0; round < 100; round++) {
            Vector3d place = edges.placeAround(new Vector3d(), far);
            Primitive hair = only(new Cylinder(
                    "hair", place, place.add(1e-3, 0, 0, new Vector3d()), radius, false, ColouredSurface.DEFAULT));
            Vector3d lamp = place.add(0, 2, 0.01 * round, new Vector3d());
            shadows += mustKeepShadow(edges, hair, List.of(hair), lamp, behind);
        }
        assertThat(shadows).isGreaterThan(50);
    }

    /** Looks for a place that only just lies in the shadow of a primitive; whether one is found, 0 or 1. */
    private static int mustKeepShadow(
            EdgeRays edges, Primitive primitive, List<Primitive> all, Vector3dc lamp, double behind) {
        Vector3d target = edges.lastOf(
                aim -> {
                    Ray shadow = shadow(lamp, aim, behind);
                    return primitive.shadows(shadow, lamp.distance(shadow.x, shadow.y, shadow.z));
                },
                primitive);
        LampShadows grid = LampShadows.of(lamp, new ObjectTree(all));
        if (target == null || grid == null) {
            return 0;
        }
        Ray ray = shadow(lamp, target, behind);
        String name = primitive.description();
        double limit = lamp.distance(ray.x, ray.y, ray.z);
        Hit start = QuickRejectionTest.startOf(ray);
        assertThat(grid.shadows(start, Ray.blank().setShadow(start, ray.dx, ray.dy, ray.dz), 0, limit, new RayCounts()))
                .as(name)
                .isTrue();
        return 1;
    }

    /** The ray to a lamp from a place behind a target, so many times as far away. */
    private static Ray shadow(Vector3dc lamp, Vector3dc target, double behind) {
        Vector3d place = target.sub(lamp, new Vector3d()).mul(behind).add(lamp);
        return EdgeRays.towards(place, lamp);
    }

    /** A coin of a million units, seen along its axis from close by. */
    @Test
    void wideFlatCylinderIsKept() {
        Primitive coin = only(new Cylinder(
                "coin", new Vector3d(0, 0, 0.3), new Vector3d(0.1, 0.2, 1.3), 1e6, true, ColouredSurface.DEFAULT));
        for (int i = 0; i < 200; i++) {
            mustKeep(coin, EdgeRays.towards(new Vector3d(0.1, 0.3, -5), new Vector3d(0.6 + 1e-9 * i, 1.3, 0)));
        }
    }

    @Test
    void whatIsOnlyJustMissedIsTold() {
        Primitive ball = only(new Sphere("ball", new Vector3d(0.3, 0.2, 0.1), 1, ColouredSurface.DEFAULT));
        Ray besideTheBox = Ray.from(1.3 + 1e-12, 0.2, -5, 0, 0, 1, 0);
        Ray beside = Ray.from(1.3 + 1e-10, 0.2, -5, 0, 0, 1, 0);

        assertThat(entry(node(ball), besideTheBox, 100)).isEqualTo(TreeNode.MISSED);
        assertThat(bundle(block(beside)).misses(ball)).isTrue();
        assertThat(bundle(block(beside)).misses(node(ball))).isTrue();
    }

    private static Primitive only(SceneObject object) {
        return PrimitiveCollector.primitivesOf(object).get(0);
    }

    private static TreeNode node(Primitive primitive) {
        return new TreeNode(primitive.bounds(), new Primitive[] {primitive}, 0, 1);
    }

    private static double entry(TreeNode node, Ray ray, double limit) {
        return node.entry(ray.x, ray.y, ray.z, 1 / ray.dx, 1 / ray.dy, 1 / ray.dz, limit);
    }

    private static RayPacket block(Ray... rays) {
        RayPacket block = new RayPacket(rays.length);
        block.begin(rays.length);
        for (int i = 0; i < rays.length; i++) {
            block.set(i, rays[i]);
        }
        return block;
    }

    private static PacketFrustum bundle(RayPacket block) {
        PacketFrustum bundle = new PacketFrustum();
        assertThat(bundle.enclose(block)).isTrue();
        return bundle;
    }
}
