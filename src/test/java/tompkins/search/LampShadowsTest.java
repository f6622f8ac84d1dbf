package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3i;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.Waiting;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.surface.ColouredSurface;

/** A lamp's grid finds the shadows that the tree finds, of few primitives and of many. */
class LampShadowsTest {

    private static final Vector3d LAMP = new Vector3d(3, 5, -7);

    @ParameterizedTest
    @ValueSource(ints = {200, 5_000, 40_000})
    void shadowsAreThoseOfTheTree(int count) {
        Random random = new Random(count);
        List<SceneObject> objects = mixed(count, random);
        objects.add(
                new Plane("behind the lamp", new Vector3d(0, 0, -20), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT));
        ObjectTree tree = new ObjectTree(primitives(objects));
        assertSameShadows(tree, LampShadows.of(LAMP, tree), random);
    }

    private static void assertSameShadows(ObjectTree tree, LampShadows grid, Random random) {
        RayCounts counts = new RayCounts();
        NearestHit scratch = new NearestHit(new RayCounts());
        int shadows = 0;
        int rays = 20_000;
        for (int i = 0; i < rays; i++) {
            Ray ray = EdgeRays.towards(place(random), LAMP);
            double distance = LAMP.distance(ray.x, ray.y, ray.z);
            Hit from = QuickRejectionTest.startOf(ray);

            boolean dark = tree.shadow(ray, distance, scratch) != null;

            assertThat(grid.shadows(from, Ray.blank().setShadow(from, ray.dx, ray.dy, ray.dz), 0, distance, counts))
                    .isEqualTo(dark);
            shadows += dark ? 1 : 0;
        }
        assertThat(shadows).isBetween(rays / 20, rays * 19 / 20);
        // what is seen elsewhere, or behind the start, is not asked
        assertThat(counts.tests).isLessThan(3L * rays);
    }

    static Vector3d place(Random random) {
        return new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-1.5, 1.5), random.nextDouble(8, 12));
    }

    /** Balls, boxes, triangles and rods that throw shadows on about half of the places. */
    static List<SceneObject> mixed(int count, Random random) {
        List<SceneObject> objects = new ArrayList<>();
        double size = 2 / Math.sqrt(count);
        for (int i = 0; i < count; i++) {
            Vector3d place = place(random);
            Vector3d other = place.add(size, 2 * size, 1.5 * size, new Vector3d());
            objects.add(
                    switch (i % 4) {
                        case 0 -> new Sphere("ball", place, size, ColouredSurface.DEFAULT);
                        case 1 -> new Box("box", place, other, ColouredSurface.DEFAULT);
                        case 2 ->
                            new Triangle(
                                    "triangle",
                                    place,
                                    other,
                                    place.add(-size, size, 0, new Vector3d()),
                                    ColouredSurface.DEFAULT);
                        default ->
                            new Cylinder(
                                    "rod",
                                    place,
                                    place.add(10 * size, 5 * size, size, new Vector3d()),
                                    size / 10,
                                    true,
                                    ColouredSurface.DEFAULT);
                    });
        }
        return objects;
    }

    static List<Primitive> primitives(List<SceneObject> objects) {
        return PrimitiveCollector.primitivesOf(new Group("all", objects));
    }

    /** Three thousand balls behind each other: a ray would ask them one by one. */
    @Test
    void crowdInOneCellIsLeftToTheTree() {
        assertThat(LampShadows.of(LAMP, row(3000))).isNull();
        assertThat(LampShadows.of(LAMP, row(900))).isNotNull();
    }

    /** Balls on a line to the lamp, and two far aside. */
    private static ObjectTree row(int count) {
        Stream<Vector3d> line = IntStream.range(0, count).mapToObj(i -> new Vector3d(LAMP).mul(0.3 * i / count));
        return new ObjectTree(primitives(Stream.concat(line, Stream.of(new Vector3d(-3), new Vector3d(3)))
                .<SceneObject>map(place -> new Sphere("ball", place, 0.001, ColouredSurface.DEFAULT))
                .toList()));
    }

    /** Many primitives: the tree answers as many rays as there are primitives, then the grid, which says the same. */
    @Test
    void gridOfVeryManyIsFilledWhenManyRaysHaveAsked() {
        Random random = new Random(5);
        ObjectTree tree = new ObjectTree(primitives(mixed(LampShadows.MANY, random)));
        LampShadows empty = LampShadows.of(LAMP, tree);
        for (int i = 1; i < tree.size(); i++) {
            assertThat(empty.gridOrNull()).isNull();
        }

        Waiting.until("the grid", () -> empty.gridOrNull() != null);
        LampShadows grid = empty.gridOrNull();

        assertSameShadows(tree, grid, random);
    }

    /** Each rod would stand in hundreds of cells. */
    @Test
    void veryManyLongRodsAreLeftToTheTree() {
        CylinderLattice usual = CylinderLattice.DEFAULT;
        CylinderLattice rods = new CylinderLattice(
                "rods",
                usual.from(),
                usual.to(),
                new Vector3i(100),
                1e-4,
                usual.surfaceAlongX(),
                usual.surfaceAlongY(),
                usual.surfaceAlongZ());

        assertThat(LampShadows.of(LAMP, new ObjectTree(PrimitiveCollector.primitivesOf(rods))))
                .isNull();
    }

    /** Thirty balls on a line, in one cell: from a place between them and the lamp none is asked. */
    @Test
    void whatLiesBehindThePlaceIsNotAsked() {
        Ray ray = EdgeRays.towards(new Vector3d(LAMP).mul(0.295), LAMP);
        RayCounts counts = new RayCounts();

        assertThat(LampShadows.of(LAMP, row(30))
                        .shadows(QuickRejectionTest.startOf(ray), ray, 0, 0.705 * LAMP.length(), counts))
                .isFalse();
        assertThat(counts.tests).isZero();
    }

    @Test
    void lampAmongThePrimitivesHasNoGrid() {
        ObjectTree tree = new ObjectTree(primitives(mixed(100, new Random(1))));

        assertThat(LampShadows.of(new Vector3d(0, 0, 10), tree)).isNull();
        assertThat(LampShadows.of(new Vector3d(0, 0, 7.9), tree)).isNull();
        assertThat(LampShadows.of(LAMP, tree)).isNotNull();
    }
}
