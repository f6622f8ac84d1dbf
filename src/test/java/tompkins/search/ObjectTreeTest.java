package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.primitive.Bounds;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.Sphere;
import tompkins.surface.ColouredSurface;

class ObjectTreeTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 50, 1000, 9000})
    void theTreeFindsWhatTheListFinds(int count) {
        List<Primitive> primitives = spheres(count, new Random(count));
        ObjectTree tree = new ObjectTree(primitives, 1);
        ObjectTree list = new ObjectTree(primitives, Integer.MAX_VALUE);
        Random random = new Random(7);
        int hits = sameHits(tree, list, () -> ray(random));

        assertThat(hits).isBetween(1, 299);
        assertThat(tree.root()).isNotNull();
        assertThat(list.root()).isNull();
    }

    /** How many of 300 rays hit something: in both the same. */
    private static int sameHits(ObjectTree tree, ObjectTree list, Supplier<Ray> rays) {
        NearestHit inTree = new NearestHit(new RayCounts());
        NearestHit inList = new NearestHit(new RayCounts());
        int hits = 0;
        for (int i = 0; i < 300; i++) {
            Ray ray = rays.get();
            boolean hit = list.nearest(ray, inList);
            hits += hit ? 1 : 0;

            assertThat(tree.nearest(ray, inTree)).isEqualTo(hit);
            assertThat(order(inTree)).isEqualTo(order(inList));
            assertThat(inTree.distance()).isEqualTo(inList.distance());
            assertThat(tree.shadow(ray, 5, inTree) == null).isEqualTo(list.shadow(ray, 5, inList) == null);
        }
        return hits;
    }

    /** 0 times infinity is no number, which must not make a box count as missed. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aRayAlongASideOfABoxMeetsIt(boolean least) {
        Bounds bounds = Bounds.around(new Vector3d(1, 2, 3), new Vector3d(2, 4, 6));
        TreeNode node = new TreeNode(bounds, new Primitive[0], 0, 0);
        double side = least ? bounds.widened().minX() : bounds.widened().maxX();

        assertThat(node.entry(side, 3, 0, 1 / 0.0, 1 / 0.0, 1, Primitive.NO_HIT))
                .isNotEqualTo(TreeNode.MISSED);
        assertThat(node.entry(1.5, 3, 0, 1 / 0.0, 1 / 0.0, 1, Primitive.NO_HIT)).isCloseTo(3, within(1e-9));
        assertThat(node.entry(1.5, 3, 7, 1 / 0.0, 1 / 0.0, 1, Primitive.NO_HIT)).isEqualTo(TreeNode.MISSED);
        assertThat(node.entry(1.5, 5, 0, 1 / 0.0, 1 / 0.0, 1, Primitive.NO_HIT)).isEqualTo(TreeNode.MISSED);
    }

    /** Of a hundred spheres in one place the first is seen, whatever the tree makes of them. */
    @ParameterizedTest
    @ValueSource(ints = {1, 1000})
    void ofEquallyNearHitsTheOneListedFirstCounts(int smallestTree) {
        ObjectTree tree = new ObjectTree(spheres(100, i -> 1, i -> new Vector3d(0, 0, 10)), smallestTree);
        NearestHit nearest = new NearestHit(new RayCounts());

        assertThat(tree.nearest(Ray.from(0, 0, 0, 0, 0, 1, 0), nearest)).isTrue();

        assertThat(nearest.primitive().description()).isEqualTo("0");
    }

    /** Which primitive was found; the tree holds copies. */
    private static int order(NearestHit nearest) {
        return nearest.primitive() == null ? -1 : nearest.primitive().order();
    }

    /** Eight balls of radius 1, by the areas of boxes: in two parts they cost 2 + 8 x 0.88 or 2 + 8 x 0.46. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 10})
    void onlyWhatLiesApartIsParted(double spacing) {
        List<Primitive> balls = spheres(8, i -> 1, i -> new Vector3d(spacing * i, 0, 0));
        assertThat(depth(tree(balls)) > 1).isEqualTo(spacing > 1);
    }

    private static TreeNode tree(List<Primitive> primitives) {
        return TreeBuilder.build(primitives.toArray(Primitive[]::new), 2);
    }

    @Test
    void manyPrimitivesInOnePlaceMakeNoDeepTree() {
        // distances that shrink by half each time: every cut takes off one
        List<Primitive> primitives =
                spheres(20_000, i -> 1e-3, i -> new Vector3d(i < 900 ? Math.scalb(1.0, -i) : 0, 0, 10));

        assertThat(depth(tree(primitives))).isLessThan(NearestHit.DEEPEST_TREE);
    }

    /** Each cut through distances that grow by a factor takes off a few: without a bound the tree is a list. */
    @ParameterizedTest
    @ValueSource(doubles = {1.01, 1.5, 4})
    void growingDistancesGiveABoundedTree(double factor) {
        // 1e-75 to 1e75; several in one place where that is fewer than there are
        int different = (int) Math.min(2000, 150 * Math.log(10) / Math.log(factor));
        IntToDoubleFunction distance = i -> Math.pow(factor, i % different - different / 2);
        // beside the axis, so that rays along it and across it pass some
        List<Primitive> primitives = spheres(
                2000,
                i -> distance.applyAsDouble(i) / 2,
                i -> new Vector3d(1, i % 3 - 1, 0).mul(distance.applyAsDouble(i)));
        ObjectTree tree = new ObjectTree(primitives, 1);
        ObjectTree list = new ObjectTree(primitives, Integer.MAX_VALUE);
        Random random = new Random(17);

        assertThat(depth(tree.root())).isLessThan(NearestHit.DEEPEST_TREE);
        int hits = sameHits(tree, list, () -> {
            Vector3d direction = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0).normalize();
            return Ray.from(random.nextDouble(), 0, 0, direction.x, direction.y, direction.z, 0);
        });
        assertThat(hits).isBetween(30, 300);
    }

    private static int depth(TreeNode node) {
        return node.primitives == null ? 1 + Math.max(depth(node.low), depth(node.high)) : 1;
    }

    private static Ray ray(Random random) {
        Vector3d from = new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-2, 2), -3);
        Vector3d to = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(0, 1));
        return EdgeRays.towards(from, to);
    }

    private static List<Primitive> spheres(int count, Random random) {
        return spheres(
                count,
                i -> 0.5 / Math.sqrt(count),
                i -> new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)));
    }

    /** Spheres that are called by their numbers. */
    private static List<Primitive> spheres(int count, IntToDoubleFunction radius, IntFunction<Vector3d> centre) {
        PrimitiveCollector collector = new PrimitiveCollector();
        for (int i = 0; i < count; i++) {
            new Sphere("" + i, centre.apply(i), radius.applyAsDouble(i), ColouredSurface.DEFAULT)
                    .addTo(collector, Placement.NONE);
        }
        return collector.primitives(0);
    }
}
