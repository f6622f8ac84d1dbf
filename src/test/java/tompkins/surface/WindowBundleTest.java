package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/** A window with the velocity of the camera takes back what the change of frame does to directions and to bundles of light. */
class WindowBundleTest {

    private static final Velocity VELOCITY = Velocity.of(0.1, -0.2, 0.6);

    static Stream<Arguments> windowsAndDirections() {
        return Stream.of(new Vector3d(0, 0, 1), new Vector3d(0.6, 0, -0.8), new Vector3d(0.48, 0.6, 0.64))
                .flatMap(direction -> List.of(
                        Arguments.of(
                                TransformationLaw.LORENTZ, new LorentzWindow(VELOCITY, WindowAxes.FRAME, 1), direction),
                        Arguments.of(
                                TransformationLaw.GALILEAN,
                                new GalileoWindow(VELOCITY, WindowAxes.FRAME, 1),
                                direction))
                        .stream());
    }

    @ParameterizedTest
    @MethodSource("windowsAndDirections")
    void behindTheWindowBundlesAreAsWideAsAtRest(TransformationLaw law, Surface window, Vector3d direction) {
        Ray ray = Ray.fromCamera(0, 0, 0, direction.x, direction.y, direction.z, 0, 1e-3);
        Hit hit = Hit.blank().set(ray, 1, 0, 0, -1, null, 0, null);

        Ray seen = law.sceneFromCamera(VELOCITY)
                .transform(window.respond(ray, hit, null).next());

        assertThat(direction.distance(seen.dx, seen.dy, seen.dz)).isLessThan(1e-14);
        assertThat(seen.spread).isCloseTo(1e-3, within(1e-16));
    }
}
