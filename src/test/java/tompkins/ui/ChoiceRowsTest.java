package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.ButtonModel;
import javax.swing.DefaultButtonModel;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Texts;

/** Rows of buttons of which one is chosen: the arrow keys choose as clicks do. */
@Timeout(300)
@NeedsDisplay
class ChoiceRowsTest {

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    @BeforeEach
    void open() {
        Studio studio = Studios.lattice()
                .withVelocity(Velocity.of(0, 0, 0.6))
                .withSettings(Studio.DEFAULT.settings().withSize(64, 48));
        driver = new WindowDriver(folder, studio, null, List.of());
        driver.click(driver.find(PictureCanvas.class, "picture"));
        JComponent diagram = driver.find(JComponent.class, Texts.get("ray.diagram"));
        WindowDriver.await("the pinned ray", diagram::isShowing);
        driver.completePicture();
    }

    private Stream<JToggleButton> toggles() {
        return Components.showing(driver.window().frame(), JToggleButton.class);
    }

    private List<List<JToggleButton>> rows() {
        Map<Object, List<JToggleButton>> rows = WindowDriver.onEventThread(() -> toggles()
                .filter(button -> group(button) != null)
                .collect(Collectors.groupingBy(ChoiceRowsTest::group, LinkedHashMap::new, Collectors.toList())));
        return new ArrayList<>(rows.values());
    }

    private static Object group(JToggleButton button) {
        ButtonModel model = button.getModel();
        return model instanceof DefaultButtonModel grouped ? grouped.getGroup() : null;
    }

    /** What a choice can change: the scene, the speed that is shown, the comparison, the diagram. */
    private List<Object> state() {
        PictureCanvas canvas = driver.window().view().canvas();
        JTextField speed = driver.find(JTextField.class, "Speed");
        JComponent diagram = driver.find(JComponent.class, Texts.get("ray.diagram"));
        return WindowDriver.onEventThread(() -> List.of(
                driver.window().model().studio(),
                speed.getText(),
                canvas.showsTwo(),
                canvas.pictureBounds(),
                String.valueOf(diagram.getToolTipText())));
    }

    @Test
    void arrowKeysChooseAsClicksDo() {
        List<List<JToggleButton>> rows = rows();
        assertThat(rows).as("the frames of the diagram").hasSize(1);
        for (List<JToggleButton> row : rows) {
            List<List<Object>> clicked = new ArrayList<>();
            for (JToggleButton button : row) {
                driver.click(button);
                clicked.add(state());
            }
            assertThat(clicked).as(row.get(0).getText()).doesNotHaveDuplicates();
            driver.click(row.get(0));
            List<List<Object>> reached = new ArrayList<>(List.of(state()));
            for (JToggleButton button : row.subList(1, row.size())) {
                driver.key(KeyEvent.VK_RIGHT);
                WindowDriver.await("the focus", button::isFocusOwner);
                reached.add(state());
            }
            assertThat(reached).as(row.get(0).getText()).isEqualTo(clicked);
        }
    }
}
