package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Camera;
import tompkins.image.LinearImage;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.surface.WindowAxes;
import tompkins.trace.SampleHistory;

/** The light of a scene that shines alike in all directions, in pictures that a fast camera takes of it. */
class LightShiftTest {

    private static final int WIDTH = 120;
    private static final int HEIGHT = 60;

    /** A white shell around the camera. */
    private static Studio shell(Camera camera, Velocity velocity, ColourLaw law) {
        SceneObject shell = new Sphere("shell", new Vector3d(), 100, Photograph.WHITE);
        return Photograph.of(List.of(shell), camera, velocity, WIDTH, HEIGHT)
                .studio()
                .withColours(law);
    }

    private static LinearImage picture(Studio studio) {
        Photograph photograph = new Photograph(studio);
        assertThat(photograph.job().report().counts().notFinite).isZero();
        return photograph.image();
    }

    /** Turned by a right angle, the camera sees a wall as bright as before. */
    @Test
    void withoutMeteringLightIsTakenAsItComes() {
        for (Vector3d view : List.of(new Vector3d(0, 0, 1), new Vector3d(1, 0, 0))) {
            Studio metered = shell(Photograph.pinhole(view, 60, 0), Velocity.of(0, 0, 0.6), ColourLaw.SEARCHLIGHT);
            Studio studio = Descriptions.with(metered, "metering", Metering.NONE);
            Photograph photograph = new Photograph(studio);
            for (int column = 0; column < WIDTH; column += 13) {
                double cosine = photograph.cameraDirection(new Vector2d(column + 0.5, 20.5)).z;
                // gamma = 1.25, D = 1/(gamma (1 - beta cos a'))
                double expected = Math.pow(1 / (1.25 * (1 - 0.6 * cosine)), 4);
                assertThat(photograph.image().value(column, 20, 0))
                        .isCloseTo((float) expected, within((float) (1e-6 * expected)));
            }
        }
    }

    @Test
    void whatMovesWithTheCameraKeepsItsColour() {
        Studio studio =
                shell(Photograph.pinhole(new Vector3d(0, 0, 1), 20, 0), Velocity.of(0, 0, 0.9), ColourLaw.DOPPLER);
        Disc disc = new Disc("disc", new Vector3d(0, 0, 1), new Vector3d(0, 0, -1), 0.05, Photograph.GREEN);
        SampleHistory life = new Photograph(studio.withCameraFrame(List.of(disc))).trace(WIDTH / 2.0, HEIGHT / 2.0);
        assertThat(life.colour()).isEqualTo(new Colour(0, 1, 0));
    }

    @ParameterizedTest
    @EnumSource(value = TransformationLaw.class, names = "LORENTZ", mode = EnumSource.Mode.EXCLUDE)
    void onlyRelativityShiftsLight(TransformationLaw law) {
        Studio studio = shell(Photograph.wholeSky(), Velocity.of(0, 0, 0.5), ColourLaw.DOPPLER)
                .withTransformation(law);
        assertThat(picture(studio).rgb())
                .isEqualTo(picture(studio.withColours(ColourLaw.UNCHANGED)).rgb());
    }

    /**
     * Waves that run with speed 1 in the frame of the camera, from sources that come towards it with beta cos(angle).
     */
    @ParameterizedTest
    @CsvSource({"0.6, 0, 2.5", "0.6, 180, 0.625", "0.6, 90, 1", "0.9, 60, 1.8181818181818181"})
    void inNewtonsWorldFrequenciesShiftToo(double speed, double cameraDegrees, double expected) {
        Studio moving = shell(Photograph.wholeSky(), Velocity.of(0, 0, speed), ColourLaw.UNCHANGED)
                .withTransformation(TransformationLaw.GALILEAN);
        SampleHistory ray = new Photograph(moving).trace(WIDTH / 2.0 + cameraDegrees / 3, HEIGHT / 2.0);
        assertThat(ray.sceneDopplerFactor()).isCloseTo(expected, within(1e-14));
    }

    static Stream<SceneObject> beforeTheLens() {
        Vector3d velocity = new Vector3d(0.9, 0, 0);
        return Stream.of(
                pane(new Vector3d(0, 0, -1), new LorentzWindow(Velocity.of(velocity), WindowAxes.FRAME, 1)),
                pane(new Vector3d(-1, 0, -1), new Mirror(1)),
                pane(new Vector3d(1, 0, -1), new Mirror(1)),
                new Sphere("glass around the lens", new Vector3d(0.3, 0, 0), 0.7, new Refractive(1)));
    }

    private static SceneObject pane(Vector3d normal, Surface surface) {
        return new Disc("pane", new Vector3d(0, 0, 1), normal, 0.7, surface);
    }

    /** Also where windows and mirrors show another direction there: the light of that one is metered. */
    @ParameterizedTest
    @MethodSource("beforeTheLens")
    void lightInTheMiddleKeepsItsBrightness(SceneObject beforeTheLens) {
        Studio studio = shell(
                        Photograph.pinhole(new Vector3d(0, 0, 1), 20, 0), Velocity.of(0.9, 0, 0), ColourLaw.SEARCHLIGHT)
                .withCameraFrame(List.of(beforeTheLens));
        Colour middle = new Photograph(studio).trace(WIDTH / 2.0, HEIGHT / 2.0).colour();
        assertThat(middle.green()).isCloseTo(1, within(1e-9));
    }

    /** Straight behind D^4 is below 2^-20 there, and is made brighter by 2^20 at most. */
    @Test
    void whatIsTooFaintStaysDark() {
        double beta = 0.99;
        Studio studio = shell(
                Photograph.pinhole(new Vector3d(0, 0, 1), 20, 0), Velocity.of(0, 0, -beta), ColourLaw.SEARCHLIGHT);
        Photograph photograph = new Photograph(studio);
        double expected = 0x1p20 * Math.pow((1 - beta) / (1 + beta), 2);
        assertThat(expected).isGreaterThan(1);
        assertThat(photograph.trace(WIDTH / 2.0, HEIGHT / 2.0).colour().green()).isCloseTo(1, within(1e-9));
        double faster = 0.999;
        Photograph dark = new Photograph(studio.withVelocity(Velocity.of(0, 0, -faster)));
        assertThat(dark.trace(WIDTH / 2.0, HEIGHT / 2.0).colour().green())
                .isCloseTo(0x1p20 * Math.pow((1 - faster) / (1 + faster), 2), within(1e-9));
    }

    /**
     * In one pixel the light is more than 1e33 times as bright as in the scene, in the middle of the picture nearly
     * dark.
     */
    @ParameterizedTest
    @EnumSource(value = ColourLaw.class, names = "UNCHANGED", mode = EnumSource.Mode.EXCLUDE)
    void nothingIsTooFast(ColourLaw law) {
        Studio atRest = shell(Photograph.wholeSky(), Velocity.REST, law);
        Vector3d ahead = new Photograph(atRest).cameraDirection(new Vector2d(3.5, 30.5));
        LinearImage picture =
                picture(atRest.withVelocity(Velocity.of(SpeedScale.GAMMA, Velocity.LARGEST_GAMMA, ahead)));
        for (float value : picture.rgb()) {
            assertThat(value).isFinite().isNotNegative();
        }
        assertThat(picture.value(3, 30, 1)).isGreaterThan(1e13f);
    }
}
