package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

class RefractiveTest {

    private static final double WEAK = 1.05 / 1024;

    /**
     * Glass of index 1.5 reflects 4 % at 0 degrees, 39 % at 80, 90 % at 89 (by the equations of Fresnel): a ray that is
     * too weak to be split goes the way of most of its light, with all of it.
     */
    @ParameterizedTest
    @CsvSource({"0, false", "80, false", "89, true"})
    void weakRayGoesTheWayOfMostOfItsLight(double degrees, boolean mirrored) {
        double dx = Math.sin(Math.toRadians(degrees));
        double dz = Math.cos(Math.toRadians(degrees));
        Ray ray = Ray.from(0, 0, 0, dx, 0, dz, 0).dimmed(WEAK);
        Hit hit = Hit.blank().set(ray, 1, 0, 0, -1, null, 0, null);

        Response response = new Refractive(1.5).respond(ray, hit, DarkTracer.DARK);

        assertThat(response.next().dz).isCloseTo(mirrored ? -dz : Math.sqrt(1 - dx * dx / 2.25), within(1e-15));
        assertThat(response.next().throughput).isEqualTo(WEAK);
        assertThat(response.factor()).isEqualTo(Colour.WHITE);
        assertThat(response.light()).isEqualTo(Colour.BLACK);
    }

    /** Glass of index 1.5 reflects 90 % at 89 degrees, however many mirrors a ray has met before. */
    @Test
    void onlyLightInsideIsCaught() {
        double dx = Math.sin(Math.toRadians(89));
        double dz = Math.cos(Math.toRadians(89));
        Ray ray = Ray.from(0, 0, 0, dx, 0, dz, 0);
        for (int mirror = 0; mirror < 40; mirror++) {
            ray = ray.bent(Hit.blank().set(ray, 0, 0, 0, -1, null, 0, null), dx, 0, dz, 1);
        }
        Hit fromOutside = Hit.blank().set(ray, 1, 0, 0, -1, null, 0, null);
        Response entering = new Refractive(1.5).respond(ray, fromOutside, DarkTracer.DARK);
        assertThat(entering.next().dz).isEqualTo(-dz);
        assertThat(entering.next().throughput).isCloseTo(0.9, within(0.01));

        double sine = 0.99 / 1.5;
        Ray inside = ray.bent(fromOutside, sine, 0, Math.sqrt(1 - sine * sine), 1);
        Hit fromInside = Hit.blank().set(inside, 1, 0, 0, 1, null, 0, null);
        Response leaving = new Refractive(1.5).respond(inside, fromInside, DarkTracer.DARK);
        assertThat(leaving.next().dx).isCloseTo(0.99, within(1e-15));
        assertThat(leaving.next().throughput).isEqualTo(1);
    }
}
