package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.ui.model.Records;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.RenderController;
import tompkins.ui.widget.Texts;

/** The line under the photograph, without a display. */
class StatusBarTest {

    /** The first scene of all may be one that cannot be pictured. */
    @Test
    void thePictureIsThatOfTheSceneBeforeOnlyIfThereWasOne() {
        try (RenderController controller = new RenderController(picture -> {}, failure -> {})) {
            StatusBar status = new StatusBar(controller);
            JLabel picture = Components.find(status.component(), JLabel.class, "status.picture");
            status.fail("too large");
            assertThat(picture.getText()).isBlank();
            status.endFailure();
            status.show(picture(Studio.DEFAULT));
            status.fail("too large");
            assertThat(picture.getText()).isEqualTo(Texts.get("status.before"));
            status.stop();
        }
    }

    @Test
    void aWideApertureThatDoesNotBlurIsSpokenOf() {
        try (RenderController controller = new RenderController(picture -> {}, failure -> {})) {
            StatusBar status = new StatusBar(controller);
            JLabel text = Components.find(status.component(), JLabel.class, "status.picture");
            Studio wide = Studio.DEFAULT.withCamera(Records.with(Studio.DEFAULT.camera(), "apertureRadius", 0.2));
            status.show(picture(wide));
            assertThat(text.getText()).endsWith("too few samples to blur");
            status.show(picture(wide.withSettings(wide.settings().withSamples(4))));
            assertThat(text.getText()).doesNotContain("blur");
            status.stop();
        }
    }

    @Test
    void theHintOfASceneWithoutObjectsGoesWithTheFirstOne() {
        try (RenderController controller = new RenderController(picture -> {}, failure -> {})) {
            StatusBar status = new StatusBar(controller);
            JLabel text = Components.find(status.component(), JLabel.class, "status.what");
            status.show(picture(Studio.DEFAULT));
            assertThat(text.getText()).isEqualTo(Texts.get("status.empty"));
            status.show(picture(Studios.sphere()));
            assertThat(text.getText()).isEqualTo(Texts.get("status.idle"));
            status.say("something else");
            status.show(picture(Studio.DEFAULT));
            assertThat(text.getText()).isEqualTo("something else");
            status.stop();
        }
    }

    private static Picture picture(Studio studio) {
        return new Picture(
                RenderPlan.of(studio), new LinearImage(1, 1, new float[3]), true, Duration.ZERO, 1, 0, List.of());
    }

    @Test
    void whatHasHappenedIsOldAfterAWhileAndWhatIsToBeDoneIsNot() {
        try (RenderController controller = new RenderController(picture -> {}, failure -> {})) {
            StatusBar asking = new StatusBar(controller, 50);
            StatusBar telling = new StatusBar(controller, 50);
            JLabel asked = Components.find(asking.component(), JLabel.class, "status.what");
            JLabel told = Components.find(telling.component(), JLabel.class, "status.what");
            WindowDriver.onEventThread(() -> {
                asking.report("Saved");
                asking.say("Click in the picture");
                telling.report("Saved");
                assertThat(told.getText()).isEqualTo("Saved");
            });
            WindowDriver.await("the usual text", () -> told.getText().equals(Texts.get("status.idle")));
            assertThat(asked.getText()).isEqualTo("Click in the picture");
            asking.stop();
            telling.stop();
        }
    }
}
