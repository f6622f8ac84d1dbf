package tompkins.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.sceneobject.EdgeRays;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.surface.ColouredSurface;

/** A block of rays finds at once what each of its rays finds by itself. */
class PacketSearchTest {

    private static final int BLOCKS = 150;

    /** Balls that are large compared with the distances between neighbouring rays, from one start and from several. */
    @ParameterizedTest
    @CsvSource({"30000, 0.02, 0", "30000, 0.02, 0.002", "3000, 0.1, 0", "3000, 0.1, 0.01", "300, 0.2, 0"})
    void whatABlockMeetsIsWhatEachRayMeets(int balls, double radius, double lens) {
        Random random = new Random(balls);
        ObjectTree tree = balls(balls, radius, random);
        NearestHit scratch = new NearestHit(new RayCounts());
        PacketSearch search = new PacketSearch(tree, scratch);
        NearestHit alone = new NearestHit(new RayCounts());
        RayPacket rays = new RayPacket(RayPacket.MOST);
        int found = 0;
        int hits = 0;
        for (int block = 0; block < BLOCKS; block++) {
            aim(rays, lens, random);
            search.begin(rays);
            found += search.together ? 1 : 0;
            for (int place = 0; place < rays.count(); place++) {
                Ray ray = rays.ray(place);
                boolean hit = search.nearest(place, Primitive.NO_HIT);
                assertThat(hit).isEqualTo(tree.nearest(ray, alone));
                if (hit) {
                    hits++;
                    assertThat(scratch.primitive()).isSameAs(alone.primitive());
                    assertThat(scratch.distance()).isEqualTo(alone.distance());
                }
            }
        }
        assertThat(found).isGreaterThan(BLOCKS / 2);
        assertThat(hits).isGreaterThan(10_000);
    }

    /** Each ray would go far into the tree; the block goes there once. */
    @Test
    void rayOfABlockTestsFewMoreThanItHits() {
        Random random = new Random(1);
        ObjectTree tree = balls(30_000, 0.02, random);
        RayCounts counts = new RayCounts();
        PacketSearch search = new PacketSearch(tree, new NearestHit(counts));
        RayPacket rays = new RayPacket(RayPacket.MOST);
        aim(rays, 0, random);

        search.begin(rays);

        assertThat(search.together).isTrue();
        assertThat(counts.tests).isBetween(100L, 2L * RayPacket.MOST);
        assertThat(counts.nodes).isLessThan(RayPacket.MOST);
    }

    /** Dust that is finer than the distance between rays. */
    @Test
    void whatIsSmallerThanAPixelIsLeftToEachRay() {
        Random random = new Random(2);
        ObjectTree tree = balls(30_000, 0.002, random);
        RayPacket rays = new RayPacket(RayPacket.MOST);
        aim(rays, 0, random);

        PacketSearch search = new PacketSearch(tree, new NearestHit(new RayCounts()));
        search.begin(rays);

        assertThat(search.together).isFalse();
    }

    private static ObjectTree balls(int count, double radius, Random random) {
        List<SceneObject> balls = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vector3d centre =
                    new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-1.5, 1.5), random.nextDouble(8, 12));
            balls.add(new Sphere("ball", centre, random.nextDouble(0.3, 2) * radius, ColouredSurface.DEFAULT));
        }
        return new ObjectTree(PrimitiveCollector.primitivesOf(new Group("balls", balls)));
    }

    /** Sixteen rows of rays, from a lens at the origin into the field. */
    private static void aim(RayPacket rays, double lens, Random random) {
        Vector3d corner = new Vector3d(random.nextDouble(-1, 0.8), random.nextDouble(-0.8, 0.6), 9);
        rays.begin(RayPacket.MOST);
        for (int place = 0; place < RayPacket.MOST; place++) {
            Vector3d target =
                    corner.add(0.012 * (place % RayPacket.SIDE), 0.012 * (place / RayPacket.SIDE), 0, new Vector3d());
            Vector3d start = new Vector3d(lens * random.nextGaussian(), lens * random.nextGaussian(), 0);
            rays.set(place, EdgeRays.towards(start, target));
        }
    }
}
