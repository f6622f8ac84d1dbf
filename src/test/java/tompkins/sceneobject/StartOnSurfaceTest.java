package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.surface.ColouredSurface;

/** Rays that start on a sphere: outwards they never meet it, inwards always at the other end of the chord. */
class StartOnSurfaceTest {

    private static final int RAYS = 2000;

    /** Radius, distance of the centre from the origin. */
    @ParameterizedTest
    @CsvSource({"1, 0", "1e4, 0", "1e4, 1e3", "1, 1e3", "1e-3, 1e5", "1e8, 1"})
    void noSpuriousAndNoLostHits(double radius, double far) {
        SplittableRandom random = new SplittableRandom(5);
        Vector3d centre = unit(random).mul(far);
        Primitive sphere = PrimitiveCollector.primitivesOf(new Sphere("", centre, radius, ColouredSurface.DEFAULT))
                .get(0);
        int naiveSpurious = 0;
        for (int i = 0; i < RAYS; i++) {
            Vector3d normal = unit(random);
            Vector3d place = new Vector3d(normal).mul(radius).add(centre);
            Vector3d d = unit(random);
            boolean outwards = d.dot(normal) > 0;
            Ray arriving = Ray.from(place.x, place.y, place.z, d.x, d.y, d.z, 0);
            Hit start = Hit.blank().set(arriving, 0, normal.x, normal.y, normal.z, sphere, 0, null);
            double distance = sphere.distance(arriving.straightOn(start, 1), Primitive.NO_HIT);
            double chord = -2 * radius * normal.dot(d);
            // where the chord is lost in the rounding of the place, both answers are right
            if (Math.abs(chord) < 1e-10 * (far + radius)) {
                continue;
            }
            if (outwards) {
                assertThat(distance).isEqualTo(Primitive.NO_HIT);
            } else {
                double error = Math.abs(distance - chord);
                assertThat(error).isLessThan(1e-15 * (radius + far) + 1e-14 * chord + 4e-16 * far);
            }
            double naive = new NaiveHits().sphere(place, d, centre, radius);
            naiveSpurious += naive < Math.abs(chord) / 2 ? 1 : 0;
        }
        assertThat(naiveSpurious)
                .as("hits of the start itself, without a memory of it")
                .isGreaterThan(RAYS / 20);
    }

    private static Vector3d unit(SplittableRandom random) {
        Vector3d vector = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        return vector.normalize();
    }
}
