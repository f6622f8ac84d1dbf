package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/**
 * A window with the velocity of the camera takes back what the change of frame does to directions and to bundles of
 * light.
 */
class WindowBundleTest {

    private static final Velocity VELOCITY = Velocity.of(0.1, -0.2, 0.6);

    @ParameterizedTest
    @CsvSource({"0, 0, 1", "0.6, 0, -0.8", "0.48, 0.6, 0.64"})
    void behindTheWindowBundlesAreAsWideAsAtRest(double x, double y, double z) {
        Ray ray = Ray.from(0, 0, 0, x, y, z, 0);
        ray.spread = 1e-3;
        Hit hit = Hit.blank().set(ray, 1, 0, 0, -1, null, 0, null);
        Map<TransformationLaw, Surface> windows = Map.of(
                TransformationLaw.LORENTZ, new LorentzWindow(VELOCITY, WindowAxes.FRAME, 1),
                TransformationLaw.GALILEAN, new GalileoWindow(VELOCITY, WindowAxes.FRAME, 1));

        windows.forEach((law, window) -> {
            Ray next = window.respond(ray, hit, null).next();
            Ray seen = law.sceneFromCamera(VELOCITY).transform(next);
            assertThat(new Vector3d(x, y, z).distance(seen.dx, seen.dy, seen.dz))
                    .as("%s", law)
                    .isLessThan(1e-14);
            assertThat(seen.spread).isCloseTo(1e-3, within(1e-16));
        });
    }

    /**
     * The velocity in the axes of the surface is turned with them; its own length is 1 to the last digit of a double.
     * The window and the change of frame are stretched by factors of the order of gamma, and so is what rounding
     * leaves.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 0.6, 0.9999999999999999})
    void aWindowUndoesAVelocityAlongItsNormal(double beta) {
        Velocity given = Velocity.of(0, 0, beta);
        Vector3d normal = new Vector3d(0.36, 0.48, -0.8);
        Velocity inFrame = Velocity.of(SpeedScale.ONE_MINUS_BETA, given.oneMinusSpeed(), normal);
        SurfaceCoordinates coordinates = new SurfaceCoordinates(0, 0, 0.8, -0.6, 0, 0.48, 0.64, 0.6);
        Surface window = new LorentzWindow(given, WindowAxes.SURFACE, 1);
        for (int i = 0; i < 50; i++) {
            Vector3d direction = new Vector3d(Math.sin(i), Math.cos(3 * i), Math.sin(7 * i + 1)).normalize();
            Ray ray = Ray.from(0, 0, 0, direction.x, direction.y, direction.z, 0);
            ray.spread = 1e-3;
            Hit hit = Hit.blank().set(ray, 1, normal.x, normal.y, normal.z, null, 0, coordinates);

            Ray turned = window.respond(ray, hit, null).next();
            Ray seen = TransformationLaw.LORENTZ.sceneFromCamera(inFrame).transform(turned);

            double rounding = 1e-15 * given.gamma();
            assertThat(Math.sqrt(turned.dx * turned.dx + turned.dy * turned.dy + turned.dz * turned.dz))
                    .isCloseTo(1, within(1e-15));
            assertThat(direction.distance(seen.dx, seen.dy, seen.dz)).isLessThan(rounding);
            assertThat(seen.spread).isCloseTo(1e-3, within(1e-3 * rounding));
            assertThat(turned.frequency).isEqualTo(1);
        }
    }
}
