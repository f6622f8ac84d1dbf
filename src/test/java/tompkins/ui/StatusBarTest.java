package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
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
            LinearImage image = new LinearImage(1, 1, new float[3]);
            status.show(new Picture(RenderPlan.of(Studio.DEFAULT), image, true, Duration.ZERO, 1, 0, List.of()));
            status.fail("too large");
            assertThat(picture.getText()).isEqualTo(Texts.get("status.before"));
            status.stop();
        }
    }

    @Test
    void whatHasHappenedIsOldAfterAWhile() {
        try (RenderController controller = new RenderController(picture -> {}, failure -> {})) {
            StatusBar status = new StatusBar(controller);
            JLabel what = Components.find(status.component(), JLabel.class, "status.what");
            WindowDriver.onEventThread(() -> {
                status.report("Saved");
                status.say("Click in the picture");
                return null;
            });
            WindowDriver.onEventThread(() -> {
                assertThat(what.getText()).isEqualTo("Click in the picture");
                status.report("Saved");
                return null;
            });
            WindowDriver.await("the usual text", () -> what.getText().equals(Texts.get("status.idle")));
            status.stop();
        }
    }
}
