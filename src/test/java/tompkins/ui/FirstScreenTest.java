package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JMenuBar;
import javax.swing.JScrollBar;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.BundledScenes;

/** What somebody sees who starts the program for the first time. */
@Timeout(300)
@NeedsDisplay
class FirstScreenTest {

    @TempDir
    private Path folder;

    @Test
    void itHasFewControls() throws IOException {
        FirstScene first = FirstScene.ofProgram(BundledScenes.studio("town-square.json"), "");
        try (WindowDriver driver = new WindowDriver(folder, first, List.of())) {
            driver.completePicture();
            WindowDriver.onEventThread(() -> {
                driver.window().frame().setSize(1366, 768);
                driver.window().frame().validate();
            });
            WindowDriver.onEventThread(() -> {});
            List<String> controls = WindowDriver.onEventThread(
                    () -> Components.showing(driver.window().frame(), JComponent.class)
                            .filter(FirstScreenTest::isControl)
                            .map(each -> each.getClass().getSimpleName() + " " + each.getName())
                            .toList());
            assertThat(controls).hasSizeLessThanOrEqualTo(20);
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
}
