package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;

/** Directions, frequencies and solid angles in the sky of a moving camera. */
class AberrationTest {

    @ParameterizedTest
    @CsvSource({"0.5, 60.0000", "0.6, 53.1301", "0.8, 36.8699", "0.9, 25.8419", "0.99, 8.1096"})
    void lightFromTheSideComesFromAhead(double speed, double cameraDegrees) {
        Photograph moving = Photograph.of(List.of(), Photograph.wholeSky(), Velocity.of(0, 0, speed), 360, 180);
        SampleHistory ray = moving.trace(180 + cameraDegrees, 90);
        double rounding = 0.5e-4 * ray.sceneDopplerFactor();
        assertThat(Math.toDegrees(Math.acos(ray.sceneDirection().z()))).isCloseTo(90, within(rounding * 1.01));
    }

    /**
     * Waves that run with speed 1 in the frame of the camera, from sources that come towards it with beta cos(angle).
     */
    @ParameterizedTest
    @CsvSource({"0.6, 0, 2.5", "0.6, 180, 0.625", "0.6, 90, 1", "0.9, 60, 1.8181818181818181"})
    void inNewtonsWorldFrequenciesShiftToo(double speed, double cameraDegrees, double expected) {
        Photograph moving = new Photograph(Studio.DEFAULT
                .withCamera(Photograph.wholeSky())
                .withVelocity(Velocity.of(0, 0, speed))
                .withTransformation(TransformationLaw.GALILEAN)
                .withSettings(Studio.DEFAULT.settings().withSize(360, 180)));
        assertThat(moving.trace(180 + cameraDegrees, 90).sceneDopplerFactor()).isCloseTo(expected, within(1e-14));
    }

    /** Speed, camera angle, Doppler factor. */
    @ParameterizedTest
    @CsvSource({"0.6, 0, 2", "0.6, 180, 0.5", "0.6, 90, 0.8", "0.6, 53.13010235415598, 1.25"})
    void crossedRaysKnowTheDopplerFactor(double speed, double cameraDegrees, double expected) {
        Photograph moving = Photograph.of(List.of(), Photograph.wholeSky(), Velocity.of(0, 0, speed), 360, 180);
        assertThat(moving.trace(180 + cameraDegrees, 90).sceneDopplerFactor()).isCloseTo(expected, within(1e-14));
    }
}
