package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JScrollBar;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.picture.PictureCanvas;

/** What a window shows first: the program's own scene beside itself at rest, a scene of the user alone. */
@NeedsDisplay
@Timeout(180)
class FirstSceneTest {

    @TempDir
    private Path folder;

    private static Studio own() throws IOException {
        Studio studio = BundledScenes.firstStudio();
        return studio.withSettings(studio.settings().withSize(160, 120).withSamples(1));
    }

    @Test
    void theOwnSceneIsSeenBesideItselfAtRestWithFewControls() throws IOException {
        try (WindowDriver driver = new WindowDriver(folder, FirstScene.ofProgram(own(), ""), List.of())) {
            PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
            WindowDriver.await("the camera at rest", () -> canvas.shown().other() != null);

            assertThat(canvas.showsTwo()).isTrue();
            assertThat(canvas.shown().now().studio().velocity().speed()).isEqualTo(0.8);
            assertThat(canvas.shown().other().studio().velocity().isRest()).isTrue();
            JComboBox<?> others = driver.find(JComboBox.class, "Compare with");
            assertThat(others.isShowing()).as("where it can be ended").isTrue();
            assertThat(others.getSelectedItem()).isEqualTo(ComparePanel.Other.AT_REST);
            assertThat(driver.find(JMenuItem.class, "menu.caption").isSelected())
                    .isTrue();
            WindowDriver.onEventThread(() -> {
                driver.window().frame().setSize(1366, 768);
                driver.window().frame().validate();
            });
            assertThat(WindowDriver.onEventThread(
                            () -> Components.showing(driver.window().frame(), JComponent.class)
                                    .filter(FirstSceneTest::isControl)
                                    .map(each -> each.getClass().getSimpleName() + " " + each.getName())
                                    .toList()))
                    .hasSizeLessThanOrEqualTo(20);
        }
    }

    /** Whether a component takes the focus, by a click or by Tab, and is in sight, outside the menu bar. */
    private static boolean isControl(JComponent component) {
        boolean hasKeys = component instanceof JComboBox
                || component.getInputMap(JComponent.WHEN_FOCUSED).allKeys() != null;
        return hasKeys
                && component.isFocusable()
                && component.isEnabled()
                && !(component instanceof JScrollBar)
                && !component.getVisibleRect().isEmpty()
                && SwingUtilities.getAncestorOfClass(JMenuBar.class, component) == null;
    }

    @Test
    void aSceneThatWasAskedForIsSeenAlone() throws IOException {
        try (WindowDriver driver = new WindowDriver(folder, new FirstScene(own(), null), List.of())) {
            PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
            driver.completePicture();

            assertThat(canvas.showsTwo()).isFalse();
            assertThat(driver.find(JMenuItem.class, "menu.caption").isSelected())
                    .isFalse();
        }
    }

    /** A lesson speaks of speeds, wherever it was opened from. */
    @Test
    void aLessonThatWasAskedForHasACaption() throws IOException {
        FirstScene lesson = new FirstScene(BundledScenes.studio("lesson-02-turned-cube.json"), null);
        try (WindowDriver driver = new WindowDriver(folder, lesson, List.of())) {
            assertThat(driver.find(JMenuItem.class, "menu.caption").isSelected())
                    .isTrue();
        }
    }
}
