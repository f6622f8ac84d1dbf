package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.sceneobject.Disc;

/** The law c' = c/m into a sheet that faces the viewer: its axes are x and y there. */
class ComplexRefractionTest {

    private static final double ROUNDING = 1e-14;

    private final SplittableRandom random = new SplittableRandom(2009);

    /** The ray that goes on; its light gets the share that it can bring. */
    private static Ray beyond(ComplexRefraction surface, Ray ray) {
        Disc disc = new Disc("sheet", new Vector3d(), new Vector3d(0, 0, -1), 10, surface);
        Primitive sheet = ImagingSheetsTest.primitive(disc);
        double distance = sheet.distance(ray, Primitive.NO_HIT);
        Response response = surface.respond(ray, sheet.hit(ray, distance), null);
        assertThat(response.factor().green()).isEqualTo(response.next().throughput);
        return response.next();
    }

    /** A ray in a direction that meets the sheet at (1, 2, 0). */
    private static Ray ray(double dx, double dy, double dz) {
        return Ray.from(1 - 3 * dx, 2 - 3 * dy, -3 * dz, dx, dy, dz, 7);
    }

    private Vector3d direction() {
        Vector3d d = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(0.05, 1));
        return d.normalize();
    }

    /** With the ratio m = r (cos a - i sin a), as complex numbers are divided. */
    @ParameterizedTest
    @CsvSource({"1, 90", "1, -30", "1.5, 0", "1.5, 40", "0.6, 200", "1, 180"})
    void dividesByTheRatio(double size, double degrees) {
        ComplexRefraction surface = new ComplexRefraction(size, degrees, 0.9);
        double real = size * Math.cos(Math.toRadians(degrees));
        double imaginary = -size * Math.sin(Math.toRadians(degrees));
        int reflected = 0;
        for (int i = 0; i < 200; i++) {
            Vector3d d = direction();
            Ray next = beyond(surface, ray(d.x, d.y, d.z));
            double x = (d.x * real + d.y * imaginary) / (size * size);
            double y = (d.y * real - d.x * imaginary) / (size * size);
            boolean passes = Math.hypot(x, y) < 1;
            reflected += passes ? 0 : 1;
            assertThat(next.dx).isCloseTo(passes ? x : d.x, within(ROUNDING));
            assertThat(next.dy).isCloseTo(passes ? y : d.y, within(ROUNDING));
            assertThat(next.dz).isCloseTo(passes ? Math.sqrt(1 - x * x - y * y) : -d.z, within(1e-12));
            assertThat(next.time).isCloseTo(4, within(ROUNDING));
            assertThat(next.slowness).isEqualTo(1);
            assertThat(next.throughput).isEqualTo(0.9);
        }
        assertThat(reflected).matches(count -> size < 1 ? count > 20 : count == 0);
    }
}
