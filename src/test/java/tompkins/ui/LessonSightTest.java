package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JRadioButton;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import tompkins.io.BundledScenes;
import tompkins.io.FactText;
import tompkins.lesson.Lesson;
import tompkins.lesson.Prediction;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/** On small screens and on projectors each page of each lesson is in sight as a whole, with the button that goes on. */
class LessonSightTest extends WindowFixture {

    /** With four answers, and with four numbers; the others are laid out without a window. */
    private static final List<String> LONG = List.of("Lesson 4", "Lesson 7", "Lesson 17");

    private static final int SETTLING = 4;

    @AfterEach
    void restore() {
        onEventThread(() -> Look.LIGHT.install());
    }

    @Test
    void everyPageIsInSightWithoutScrolling() throws IOException {
        driver = new WindowDriver(folder, Studios.sphere(), null, List.of(Studios.sphere()));
        onEventThread(() -> {
            driver.window().setLook(Look.PROJECTOR);
            // the screen of an old projector, of which the desktop takes some
            driver.window().frame().setSize(1024, 700);
        });
        List<Studio> lessons = BundledScenes.studios().stream()
                .filter(studio -> LONG.contains(studio.shortTitle()))
                .toList();
        assertThat(lessons).hasSameSizeAs(LONG);
        lessons.forEach(this::tryAll);
    }

    private void tryAll(Studio studio) {
        Lesson lesson = (Lesson) studio.lesson();
        onEventThread(() -> {
            driver.window().model().open(studio, null);
            driver.window().view().stop();
        });
        look(studio, "PREDICT", foot());
        // the wrong answer with the longest reply
        Prediction wrong = lesson.predictions().stream()
                .filter(prediction -> !lesson.isRight(prediction))
                .reduce((first, second) ->
                        first.reply().length() > second.reply().length() ? first : second)
                .orElseThrow();
        press(JRadioButton.class, wrong.text());
        press(JRadioButton.class, Texts.get("lesson.sure"));
        press(JButton.class, Texts.get("lesson.next.LOOK"));
        look(studio, "LOOK", note(FactText.readable(studio.remarks())));
        JSlider slider = Components.find(
                panel(),
                JSlider.class,
                Texts.get("slider.name", lesson.control().name()));
        onEventThread(() -> slider.setValue(slider.getMaximum()));
        press(JButton.class, Texts.get("lesson.next.REASON"));
        look(studio, "REASON", foot());
        press(JButton.class, Texts.get("lesson.next.MEASURE"));
        await(
                "the numbers of " + studio.title(),
                () -> notes().anyMatch(area -> area.getText().startsWith("Measured")));
        look(studio, "MEASURE", foot());
    }

    /** What stands below the page and its slider. */
    private JButton foot() {
        return Components.find(panel(), JButton.class, Texts.get("lesson.again"));
    }

    private <C extends AbstractButton> void press(Class<C> type, String name) {
        C button = Components.find(panel(), type, name);
        onEventThread(() -> button.doClick(0));
    }

    private Stream<JTextArea> notes() {
        return Components.showing(panel(), JTextArea.class);
    }

    private JComponent note(String text) {
        return notes().filter(area -> text.equals(area.getText())).findFirst().orElseThrow();
    }

    private JScrollPane panel() {
        return driver.find(JScrollPane.class, "panel");
    }

    /** Fails if the lowest part that is needed is not seen, with all that is above. */
    private void look(Studio studio, String page, JComponent lowest) {
        // heights of texts follow from their widths, some events later
        for (int i = 0; i < SETTLING; i++) {
            onEventThread(() -> driver.window().frame().validate());
        }
        onEventThread(() -> {
            JScrollPane panel = panel();
            Rectangle seen = new Rectangle(panel.getViewport().getExtentSize());
            Rectangle bounds = SwingUtilities.convertRectangle(
                    lowest.getParent(), lowest.getBounds(), panel.getViewport().getView());
            if (lowest instanceof JButton) {
                // only what stands above it is needed
                bounds.height = 1;
            }
            assertThat(lowest.isShowing() && !bounds.isEmpty() && seen.contains(bounds))
                    .as("%s, %s: %s in %s", studio.shortTitle(), page, bounds, seen)
                    .isTrue();
        });
    }
}
