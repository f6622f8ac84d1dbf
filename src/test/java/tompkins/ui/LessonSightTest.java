package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
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
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.TestRun;
import tompkins.io.BundledScenes;
import tompkins.io.FactText;
import tompkins.lesson.Lesson;
import tompkins.lesson.Prediction;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Texts;

/** On small screens and on projectors each page of each lesson is in sight as a whole, with the button that goes on. */
@Timeout(600)
@NeedsDisplay
class LessonSightTest {

    /** Screens of laptops and of old projectors, of which the desktop may take some. */
    private static final List<Dimension> SIZES = List.of(new Dimension(1024, 700), new Dimension(1366, 768));

    /** With four answers, and with four numbers. */
    private static final List<String> LONG = List.of("Lesson 4", "Lesson 7", "Lesson 17");

    private static final int SETTLING = 4;

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    private final List<String> hidden = new ArrayList<>();

    @AfterEach
    void restore() {
        WindowDriver.onEventThread(() -> Look.LIGHT.install());
    }

    @Test
    void everyPageIsInSightWithoutScrolling() throws IOException {
        driver = new WindowDriver(folder, Studios.sphere(), null, List.of(Studios.sphere()));
        List<Studio> lessons = BundledScenes.studios().stream()
                .filter(studio -> studio.lesson() instanceof Lesson)
                // the others are laid out without a window
                .filter(studio -> TestRun.THOROUGH || LONG.contains(studio.shortTitle()))
                .toList();
        assertThat(lessons).hasSizeGreaterThan(1);
        for (Look look : TestRun.THOROUGH ? List.of(Look.PROJECTOR, Look.LIGHT) : List.of(Look.PROJECTOR)) {
            WindowDriver.onEventThread(() -> driver.window().setLook(look));
            lessons.forEach(this::tryAll);
        }
        assertThat(hidden).isEmpty();
    }

    private void tryAll(Studio studio) {
        Lesson lesson = (Lesson) studio.lesson();
        WindowDriver.onEventThread(() -> {
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
        WindowDriver.onEventThread(() -> slider.setValue(slider.getMaximum()));
        press(JButton.class, Texts.get("lesson.next.REASON"));
        look(studio, "REASON", foot());
        press(JButton.class, Texts.get("lesson.next.MEASURE"));
        WindowDriver.await(
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
        WindowDriver.onEventThread(() -> button.doClick(0));
    }

    private Stream<JTextArea> notes() {
        return Components.showing(panel(), JTextArea.class);
    }

    private JComponent note(String text) {
        return notes().filter(area -> text.equals(area.getText())).findFirst().orElseThrow();
    }

    private JScrollPane panel() {
        return Components.find(driver.window().frame(), JScrollPane.class, "panel");
    }

    /** Notes it if the lowest part that is needed is not seen, with all that is above, in one of the sizes. */
    private void look(Studio studio, String page, JComponent lowest) {
        for (Dimension size : SIZES) {
            WindowDriver.onEventThread(() -> driver.window().frame().setSize(size));
            // heights of texts follow from their widths, some events later
            for (int i = 0; i < SETTLING; i++) {
                WindowDriver.onEventThread(() -> driver.window().frame().validate());
            }
            WindowDriver.onEventThread(() -> {
                JScrollPane panel = panel();
                Rectangle seen = new Rectangle(panel.getViewport().getExtentSize());
                Rectangle bounds = SwingUtilities.convertRectangle(
                        lowest.getParent(),
                        lowest.getBounds(),
                        panel.getViewport().getView());
                if (lowest instanceof JButton) {
                    // only what stands above it is needed
                    bounds.height = 1;
                }
                if (!lowest.isShowing() || bounds.isEmpty() || !seen.contains(bounds)) {
                    hidden.add(String.format(
                            Locale.ROOT,
                            "%s, %s, %d x %d: %s in %s",
                            studio.shortTitle(),
                            page,
                            size.width,
                            size.height,
                            bounds,
                            seen));
                }
            });
        }
    }
}
