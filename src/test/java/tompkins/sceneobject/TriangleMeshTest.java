package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.primitive.Primitive;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.surface.ColouredSurface;

class TriangleMeshTest {

    /** The octahedron |x| + |y| + |z| = 1: along each ray it is met where that sum is 1. */
    @Test
    void raysMeetTheOctahedronWhereItsEquationSays() {
        ObjectTree tree = new ObjectTree(PrimitiveCollector.primitivesOf(TriangleMesh.DEFAULT), 2);
        NearestHit nearest = new NearestHit(new RayCounts());
        Random random = new Random(1);

        for (int i = 0; i < 1000; i++) {
            Vector3d target = new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            target.mul(0.9 / (Math.abs(target.x) + Math.abs(target.y) + Math.abs(target.z)));
            Vector3d start =
                    new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalize(5);
            Vector3d direction = target.sub(start, new Vector3d()).normalize();
            Ray ray = Ray.from(start.x, start.y, start.z, direction.x, direction.y, direction.z, 0);

            assertThat(tree.nearest(ray, nearest)).isTrue();
            double distance = nearest.distance();
            double sum = Math.abs(start.x + distance * direction.x)
                    + Math.abs(start.y + distance * direction.y)
                    + Math.abs(start.z + distance * direction.z);
            assertThat(sum).isCloseTo(1, within(1e-14));
            assertThat(distance).as("the nearer side").isLessThan(start.distance(target));
            assertThat(nearest.primitive().hit(ray, nearest.distance()).cosine(ray))
                    .as("normals point outwards")
                    .isNegative();
        }
    }

    @Test
    void trianglesWithoutAreaAreLeftOut() {
        MeshData mesh = new MeshData(
                "flat.obj",
                new double[] {0, 0, 1, 1, 0, 1, 2, 0, 1, 0, 1, 1},
                new int[] {0, 1, 2, 0, 0, 3, 0, 1, 3},
                MeshDetail.NONE,
                new byte[0]);

        List<Primitive> primitives =
                PrimitiveCollector.primitivesOf(new TriangleMesh("flat", mesh, ColouredSurface.DEFAULT, true));

        assertThat(primitives).hasSize(1);
    }
}
