package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.PanoramicCamera;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.SkyBackground;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;

/** Directions, frequencies and solid angles in the sky of a moving camera. */
class AberrationTest {

    /** A sky that is white in the upper half of the scene and black below. */
    private static Photograph halfLitSky(double speed, PanoramicCamera camera, int width, int height) {
        Studio dark = Photograph.of(List.of(), camera, Velocity.of(0, speed, 0), width, height)
                .studio();
        return new Photograph(
                Descriptions.with(dark, "background", new SkyBackground(Colour.WHITE, Colour.WHITE, Colour.BLACK)));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 60.0000", "0.6, 53.1301", "0.8, 36.8699", "0.9, 25.8419", "0.99, 8.1096"})
    void lightFromTheSideComesFromAhead(double speed, double cameraDegrees) {
        Photograph moving = Photograph.of(List.of(), Photograph.wholeSky(), Velocity.of(0, 0, speed), 360, 180);
        SampleHistory ray = moving.trace(180 + cameraDegrees, 90);
        double rounding = 0.5e-4 * ray.sceneDopplerFactor();
        assertThat(Math.toDegrees(Math.acos(ray.sceneDirection().z()))).isCloseTo(90, within(rounding * 1.01));
    }

    @Test
    void signOfTheTracedDirection() {
        Photograph moving = Photograph.of(List.of(), Photograph.wholeSky(), Velocity.of(0, 0, 0.9), 360, 180);
        SampleHistory ray = moving.trace(270, 90);
        assertThat(ray.cameraDirection().distance(1, 0, 0)).isLessThan(1e-15);
        assertThat(ray.sceneDirection().distance(Math.sqrt(1 - 0.81), 0, -0.9)).isLessThan(1e-15);
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

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 0.9, 0.99})
    void theHorizonStandsWhereTheCosineIsTheSpeed(double speed) {
        Photograph sky = halfLitSky(speed, Photograph.wholeSky(), 8, 720);
        int lit = 0;
        while (sky.isLit(3, lit, 0)) {
            lit++;
        }
        assertThat(lit * 0.25).isCloseTo(Math.toDegrees(Math.acos(speed)), within(0.126));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 0.9})
    void halfTheSkyShrinksInSolidAngle(double speed) {
        Photograph sky = halfLitSky(speed, Photograph.wholeSky(), 16, 720);
        LinearImage picture = sky.image();
        double share = 0;
        for (int row = 0; row < 720; row++) {
            double step = Math.PI / 720;
            double solidAngle = 2 * Math.PI / 16 * 2 * Math.sin((row + 0.5) * step) * Math.sin(step / 2);
            for (int column = 0; column < 16; column++) {
                share += picture.value(column, row, 0) * solidAngle / (4 * Math.PI);
            }
        }
        assertThat(share).isCloseTo((1 - speed) / 2, within(0.5 / 720 * Math.PI / 2));
    }

    /** Solid angles of the pixels, taken to the scene by 1/D^2 with D from the traced rays. */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 0.9})
    void forwardHalfOfTheSkyHoldsMoreThanHalfOfTheScene(double speed) {
        Photograph moving = Photograph.of(List.of(), Photograph.wholeSky(), Velocity.of(0, speed, 0), 1, 2000);
        double held = 0;
        double all = 0;
        double step = Math.PI / 2000;
        for (int row = 0; row < 2000; row++) {
            double ratio = moving.trace(0.5, row + 0.5).sceneDopplerFactor();
            double sceneSolidAngle = Math.sin((row + 0.5) * step) * step / 2 * ratio * ratio;
            all += sceneSolidAngle;
            held += row < 1000 ? sceneSolidAngle : 0;
        }
        assertThat(all).isCloseTo(1, within(1e-4));
        assertThat(held).isCloseTo((1 + speed) / 2, within(1e-4));
    }

    @Test
    void speedsNextToThatOfLightStayFinite() {
        Photograph sky = halfLitSky(1 - 1e-9, Photograph.wholeSky(), 32, 64);
        for (float value : sky.image().rgb()) {
            assertThat(value).isBetween(0f, 1f);
        }
        assertThat(sky.job().report().warnings()).isEmpty();
        SampleHistory sideways = sky.trace(16, 32);
        double gamma = 1 / Math.sqrt(1e-9 * (2 - 1e-9));
        assertThat(sideways.sceneDopplerFactor() * gamma).isCloseTo(1, within(1e-7));
    }

    @Test
    void intervalsAreTheSameInBothFrames() {
        Photograph moving = Photograph.of(
                List.of(), Photograph.pinhole(new Vector3d(0, 0, 1), 20, 3), Velocity.of(0.2, -0.1, 0.97), 8, 8);
        SampleHistory ray = moving.with(new AperturePlaneShutter(3)).trace(1, 2);
        double before = ray.cameraStart().position().lengthSquared()
                - Math.pow(ray.cameraStart().time(), 2);
        double after = ray.sceneStart().position().lengthSquared()
                - Math.pow(ray.sceneStart().time(), 2);
        assertThat(before).isEqualTo(-9);
        assertThat(after).isCloseTo(before, within(1e-12));
        assertThat(ray.sceneDirection().length()).isCloseTo(1, within(1e-14));
    }
}
