package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.BundledScenes;
import tompkins.property.Descriptions;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.picture.PictureCanvas;

/** What a window shows first: the program's own scene beside itself at rest, a scene of the user alone. */
@NeedsDisplay
@Timeout(180)
class FirstSceneTest {

    private static final Studio ANOTHER = Descriptions.with(Studios.sphere(), "title", "Another scene");

    @TempDir
    private Path folder;

    private static Studio own() throws IOException {
        Studio studio = BundledScenes.firstStudio();
        return studio.withSettings(studio.settings().withSize(160, 120).withSamples(1));
    }

    @Test
    void theOwnSceneIsSeenBesideItselfAtRest() throws IOException {
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
        }
    }

    private void openAnother(WindowDriver driver) {
        JMenuItem another = driver.find(JMenuItem.class, ANOTHER.title());
        WindowDriver.onEventThread(() -> another.doClick());
        WindowDriver.await(
                "the other scene", () -> driver.picture().studio().title().equals(ANOTHER.title()));
    }

    /** Nobody asked for the camera at rest; who opens a scene wants to see that. */
    @Test
    void theComparisonEndsWithTheFirstScene() throws IOException {
        try (WindowDriver driver = new WindowDriver(folder, FirstScene.ofProgram(own(), ""), List.of(ANOTHER))) {
            PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
            WindowDriver.await("the camera at rest", () -> canvas.shown().other() != null);
            JComboBox<?> others = driver.find(JComboBox.class, "Compare with");

            openAnother(driver);

            assertThat(others.getSelectedItem()).isEqualTo(ComparePanel.Other.NOTHING);
            assertThat(WindowDriver.onEventThread(canvas::showsTwo)).isFalse();
        }
    }

    @Test
    void aComparisonThatWasChosenStays() throws IOException {
        try (WindowDriver driver = new WindowDriver(folder, FirstScene.ofProgram(own(), ""), List.of(ANOTHER))) {
            PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
            WindowDriver.await("the camera at rest", () -> canvas.shown().other() != null);
            JComboBox<?> others = driver.find(JComboBox.class, "Compare with");
            WindowDriver.onEventThread(() -> others.setSelectedItem(ComparePanel.Other.GALILEAN_CAMERA));

            openAnother(driver);

            assertThat(others.getSelectedItem()).isEqualTo(ComparePanel.Other.GALILEAN_CAMERA);
        }
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
