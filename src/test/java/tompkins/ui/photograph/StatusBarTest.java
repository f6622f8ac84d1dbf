package tompkins.ui.photograph;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Point2D;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import tompkins.image.LinearImage;
import tompkins.image.PictureLabel;
import tompkins.property.Descriptions;
import tompkins.studio.PanoramaBackground;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;
import tompkins.ui.Components;
import tompkins.ui.WindowDriver;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.Pictures;
import tompkins.ui.picture.RenderController;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Texts;

class StatusBarTest {

    private static final int SOON = 50;

    @AutoClose
    private final RenderController controller = new RenderController(picture -> {}, failure -> {});

    private final StatusBar status = new StatusBar(controller, SOON);
    private final JLabel what = label(status, "status.what");
    private final JLabel picture = label(status, "status.picture");

    @AfterEach
    void stop() {
        status.stop();
    }

    private static JLabel label(StatusBar status, String name) {
        return Components.find(status.component(), JLabel.class, name);
    }

    private static Picture picture(Studio studio, String... warnings) {
        return Pictures.of(studio, RenderPlan.of(studio), new LinearImage(1, 1, new float[3]), 0, warnings);
    }

    /** The first scene of all may be one that cannot be pictured. */
    @Test
    void thePictureIsThatOfTheSceneBeforeOnlyIfThereWasOne() {
        status.fail("too large");
        assertThat(picture.getText()).isBlank();
        status.endFailure();
        status.show(picture(Studio.DEFAULT));
        status.fail("too large");
        assertThat(picture.getText()).isEqualTo(Texts.get("status.before"));
    }

    @Test
    void anUnknownErrorIsNotSpokenOf() {
        status.show(picture(Studio.DEFAULT));
        assertThat(picture.getText()).contains("error 0");
        status.show(Pictures.black(Studio.DEFAULT));
        assertThat(picture.getText())
                .contains("1 sample per pixel")
                .doesNotContain("error")
                .doesNotContain("?");
    }

    /** In a narrow line it gives up its end, as a label with fewer words. */
    @Test
    void theHintIsNotCutInAWord() throws InterruptedException, InvocationTargetException {
        String hint = Texts.get("status.idle.PIN");
        SwingUtilities.invokeAndWait(() -> {
            int all = what.getFontMetrics(what.getFont()).stringWidth(hint);
            for (int width : new int[] {all / 4, all / 2, all + 2}) {
                String fitting = PictureLabel.shortened(hint, what.getFontMetrics(what.getFont()), width);
                assertThat(fitting.equals(hint)).isEqualTo(width > all);
                assertThat(painted(what, width)).isEqualTo(painted(new JLabel(fitting), width));
            }
        });
        assertThat(what.getText()).isEqualTo(hint);
    }

    private static List<Integer> painted(JLabel label, int width) {
        label.setSize(width, 20);
        return IntStream.of(Pictures.painted(label)).boxed().toList();
    }

    /** A warning may not hide it: whoever measures waits for a click. */
    @Test
    void whatAClickDoesIsSaidInANarrowWindow() {
        status.show(picture(Studios.sphere(), "all is black"));
        status.showHint(Texts.get("status.idle.MEASURE"));
        assertThat(what.getText()).isEqualTo(Texts.get("status.idle.MEASURE"));
        status.showHint(Texts.get("status.idle.CHOOSE"));
        assertThat(what.getText()).isEqualTo(Texts.get("status.idle.CHOOSE"));
        status.showHint("");
        assertThat(what.getText()).isEqualTo("Warning: all is black.");
    }

    @Test
    void aWideApertureThatDoesNotBlurIsSpokenOf() {
        Studio wide = Studio.DEFAULT.withCamera(Descriptions.with(Studio.DEFAULT.camera(), "apertureRadius", 0.2));
        status.show(picture(wide));
        assertThat(picture.getText()).endsWith("too few samples to blur");
        status.show(picture(wide.withSettings(wide.settings().withSamples(4))));
        assertThat(picture.getText()).doesNotContain("blur");
    }

    @Test
    void theHintOfASceneWithoutObjectsGoesWithTheFirstOne() {
        status.show(picture(Studio.DEFAULT));
        assertThat(what.getText()).isEqualTo(Texts.get("status.empty"));
        status.show(picture(Studios.sphere()));
        assertThat(what.getText()).isEqualTo(Texts.get("status.idle.PIN"));
        status.show(picture(Descriptions.with(Studio.DEFAULT, "background", PanoramaBackground.DEFAULT)));
        assertThat(what.getText()).as("the sky is there to be seen").isEqualTo(Texts.get("status.idle.PIN"));
        status.say("something else");
        status.show(picture(Studio.DEFAULT));
        assertThat(what.getText()).isEqualTo("something else");
    }

    /** The section that has all of them may be folded. */
    @Test
    void aWarningStaysUntilAPictureHasNone() {
        status.show(picture(Studios.sphere(), "no ray met an object", "all is black"));
        assertThat(what.getText()).isEqualTo("Warning: no ray met an object.");
        status.say("something else");
        status.show(null, false);
        assertThat(what.getText()).isEqualTo("Warning: no ray met an object.");
        status.show(picture(Studios.sphere()));
        assertThat(what.getText()).isEqualTo(Texts.get("status.idle.PIN"));
    }

    /** A reading under the mouse, or a message, comes between. */
    @Test
    void whatAClickDoesIsSaidUntilItDoesAnotherThing() {
        status.showHint(Texts.get("status.idle.CHOOSE"));
        assertThat(what.getText()).contains("choose an object or a lamp").doesNotContain("ray");
        status.showHint(Texts.get("status.idle.MEASURE"));
        assertThat(what.getText()).contains("measure there").doesNotContain("ray");
        status.showHint(Texts.get("status.idle.CHOOSE"));
        status.say("something else");
        status.show(null, false);
        status.show(picture(Studios.sphere()));
        assertThat(what.getText()).isEqualTo(Texts.get("status.idle.CHOOSE"));
        status.showHint("");
        assertThat(what.getText()).isEqualTo(Texts.get("status.idle.PIN"));
        status.say("nothing is there");
        status.showHint("");
        assertThat(what.getText()).isEqualTo("nothing is there");
    }

    /** What lies under a mouse that rests is read again in each picture, which may have another size. */
    @Test
    void newsStayWhileTheMouseRests() {
        Picture seen = picture(Studios.sphere());
        PixelReading reading = PixelReading.of(seen, new Point2D.Double(3, 4));
        WindowDriver.onEventThread(() -> {
            status.show(reading, false);
            status.report("Saved");
            status.show(PixelReading.of(seen, new Point2D.Double(2, 3)), true);
            assertThat(what.getText()).isEqualTo("Saved");
        });
        WindowDriver.await("the reading", () -> what.getText().startsWith("Pixel 2, 3"));
        WindowDriver.onEventThread(() -> {
            status.report("Saved");
            status.show(PixelReading.of(seen, new Point2D.Double(5, 4)), false);
            assertThat(what.getText()).startsWith("Pixel 5, 4");
        });
    }

    @Test
    void reportsGrowOldAndRequestsDoNot() {
        StatusBar asking = new StatusBar(controller, SOON);
        WindowDriver.onEventThread(() -> {
            asking.report("Saved");
            asking.say("Click in the picture");
            status.report("Saved");
            assertThat(what.getText()).isEqualTo("Saved");
        });
        WindowDriver.await("the usual text", () -> what.getText().equals(Texts.get("status.idle.PIN")));
        assertThat(label(asking, "status.what").getText()).isEqualTo("Click in the picture");
        asking.stop();
    }
}
