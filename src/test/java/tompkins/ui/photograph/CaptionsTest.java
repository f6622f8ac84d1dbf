package tompkins.ui.photograph;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.light.ColourLaw;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Moving;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.ui.model.Settings;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.picture.PictureCanvas;

class CaptionsTest {

    /** 3-4-5: gamma is exactly 1.25. */
    private static final Studio FAST = Studios.sphere().withVelocity(Velocity.of(0, 0, 0.6));

    @TempDir
    private Path folder;

    @Test
    void theyTellTheSpeedAndWhateverIsUnusual() {
        assertThat(Captions.of(FAST, null)).isEqualTo("\u03b2 = 0.6, \u03b3 = 1.25");
        assertThat(Captions.of(Studios.sphere(), null)).isEqualTo("\u03b2 = 0, \u03b3 = 1");
        assertThat(Captions.of(FAST.withTransformation(TransformationLaw.GALILEAN), null))
                .isEqualTo("\u03b2 = 0.6, Galilean");
        assertThat(Captions.of(FAST.withColours(ColourLaw.DOPPLER), null))
                .isEqualTo("\u03b2 = 0.6, \u03b3 = 1.25, Doppler shift");
        assertThat(Captions.of(FAST.withColours(ColourLaw.DOPPLER).withView(View.MEASURED), null))
                .as("what is measured has its own colours")
                .isEqualTo("Measured, not a photograph, \u03b2 = 0.6, \u03b3 = 1.25");
    }

    /** No one shall take for a photograph what none is, whatever captions are wanted. */
    @Test
    void whatIsNoPhotographAlwaysSaysSo() {
        Studio measured = FAST.withView(View.MEASURED);
        Captions captions =
                new Captions(new PictureCanvas(size -> {}), new Settings(folder.resolve("window.properties")), false);
        assertThat(captions.shown(FAST)).isEmpty();
        assertThat(captions.shown(measured)).isEqualTo("Measured, not a photograph");
        captions.setShown(true);
        assertThat(captions.shown(measured)).isEqualTo("Measured, not a photograph, \u03b2 = 0.6, \u03b3 = 1.25");
        assertThat(Captions.ofPictures(measured, StudioNumber.OPENING_TIME, false)
                        .of(measured, 0))
                .isEqualTo("Measured, not a photograph");
    }

    /** Otherwise one would read that a cube which flies has no speed. */
    @Test
    void theySayWhatMoves() {
        Moving cube = Descriptions.with(Moving.DEFAULT, "description", "cube");
        Studio studio = Studio.DEFAULT.withScene(List.of(cube));
        assertThat(Captions.of(studio, null)).isEqualTo("camera at rest, cube \u03b2 = 0.5");
        assertThat(Captions.of(studio.withVelocity(Velocity.of(0, 0, 0.6)), null))
                .isEqualTo("camera \u03b2 = 0.6, \u03b3 = 1.25, cube \u03b2 = 0.5");
        Moving second = Descriptions.with(cube, "description", "second");
        Moving third = Descriptions.with(cube, "description", "third");
        assertThat(Captions.of(studio.withScene(List.of(cube, cube, second, third)), null))
                .isEqualTo("camera at rest, 3 moving objects");
        Moving still = Descriptions.with(third, "velocity", Velocity.REST);
        assertThat(Captions.of(studio.withScene(List.of(cube, second, still)), null))
                .as("a clock that rests among others")
                .isEqualTo("camera at rest, cube \u03b2 = 0.5, second \u03b2 = 0.5");
    }

    /** Otherwise the screen would tell two speeds, that of the picture and that of the next. */
    @Test
    void onARideTheLineOfTheRideTellsTheSpeed() {
        Captions captions =
                new Captions(new PictureCanvas(size -> {}), new Settings(folder.resolve("window.properties")), true);
        captions.setRidden(() -> true);
        assertThat(captions.onScreen(FAST)).isEmpty();
        assertThat(captions.onScreen(FAST.withView(View.MEASURED))).isEqualTo("Measured, not a photograph");
        assertThat(Captions.parts(RideMoment.start(FAST.withView(View.MEASURED)), true))
                .as("what the caption says the line need not say")
                .containsExactly("\u03b2 = 0.6, \u03b3 = 1.25", "on board 0.0, scene 0.0 time units");
        assertThat(captions.shown(FAST)).as("in a copy").isEqualTo("\u03b2 = 0.6, \u03b3 = 1.25");
        captions.setRidden(() -> false);
        assertThat(captions.onScreen(FAST)).isEqualTo("\u03b2 = 0.6, \u03b3 = 1.25");
    }

    /** As in the caption of a photograph, and never 1 for what moves. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.03, 1.00045", "0.001, 1 + 5e-7", "0.6, 1.25", "0.28, 1.042"})
    void theGammaOfARideIsThatOfACaption(double beta, String gamma) {
        Studio studio = Studios.sphere().withVelocity(Velocity.of(0, 0, beta));
        for (boolean goesOn : new boolean[] {true, false}) {
            assertThat(Captions.of(RideMoment.start(studio), goesOn))
                    .contains(", \u03b3 = " + gamma + ", on board 0.0");
        }
        assertThat(Captions.of(studio, null)).endsWith("\u03b3 = " + gamma);
    }

    /** It comes first: in a small picture the end of a long caption is cut off. */
    @Test
    void theyTellTheNumberThatIsAnimated() {
        Studio later = StudioNumber.OPENING_TIME.with(FAST, 1.5);
        assertThat(Captions.of(later, NumberProperty.openingTime()))
                .isEqualTo("Opening time of the shutter = 1.5, \u03b2 = 0.6, \u03b3 = 1.25");
        assertThat(Captions.of(later, NumberProperty.speed(SpeedScale.RAPIDITY)))
                .as("the speed is told already")
                .isEqualTo("\u03b2 = 0.6, \u03b3 = 1.25");
        Studio without = later.withCamera(later.camera().withShutter(FixedPointSurfaceShutter.DEFAULT));
        assertThat(Captions.of(without, NumberProperty.openingTime()))
                .as("this shutter has none")
                .isEqualTo("\u03b2 = 0.6, \u03b3 = 1.25");
    }

    @Test
    void theWishIsRemembered() {
        Settings settings = new Settings(folder.resolve("window.properties"));
        Captions captions = new Captions(new PictureCanvas(size -> {}), settings, false);
        assertThat(captions.areShown()).isFalse();
        captions.setShown(true);
        Settings again = new Settings(folder.resolve("window.properties"));
        assertThat(new Captions(new PictureCanvas(size -> {}), again, false).areShown())
                .isTrue();
    }
}
