package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButton;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.BundledScenes;
import tompkins.sceneobject.Moving;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.widget.Texts;

/** A lesson in the window, from its menu to its numbers. */
@Timeout(600)
@NeedsDisplay
@Tag("slow")
class LessonWindowTest {

    @TempDir
    private Path folder;

    private Studio cube;

    @AutoClose
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        Studio scene = BundledScenes.studio("lesson-02-turned-cube.json");
        cube = scene.withSettings(scene.settings().withSize(80, 60));
        driver = new WindowDriver(folder.resolve("settings"), Studios.sphere(), null, List.of(Studios.sphere(), cube));
        WindowDriver.await(
                "the lessons",
                () -> Components.all(driver.window().frame())
                        .anyMatch(item -> cube.title().equals(item.getName())));
        driver.completePicture();
    }

    private void begin() {
        driver.menu(cube.title());
        WindowDriver.await("the lesson", () -> driver.window().model().studio().equals(cube));
        driver.completePicture();
    }

    private void press(String key) {
        driver.click(driver.find(JButton.class, Texts.get(key)));
    }

    private boolean shows(String text) {
        return Components.showing(driver.window().frame(), JLabel.class)
                .anyMatch(label -> text.equals(label.getText()));
    }

    @Test
    void lessonsHaveAMenuOfTheirOwn() {
        JMenu lessons = driver.find(JMenu.class, "menu.lessons");
        assertThat(lessons.getMenuComponents())
                .extracting(item -> ((JMenuItem) item).getText())
                .containsExactly(cube.title());
        JMenu examples = driver.find(JMenu.class, "menu.examples");
        assertThat(Components.all(examples)).noneMatch(item -> cube.title().equals(item.getName()));
    }

    /** Together they leave no room for the picture. */
    @Test
    void aLessonClosesTheBarsUnderThePicture() {
        driver.menu("menu.ride");
        driver.menu("menu.playPanel");
        driver.menu("menu.measure");
        List<String> bars = List.of("ride.close", "play.close", "measure.close");
        assertThat(bars).allMatch(this::isShown);
        begin();
        assertThat(bars).noneMatch(this::isShown);
        assertThat(isShown("lesson.again")).isTrue();
    }

    private boolean isShown(String button) {
        return WindowDriver.onEventThread(
                () -> Components.showing(driver.window().frame(), JButton.class)
                        .anyMatch(each -> Texts.get(button)
                                .equals(each.getAccessibleContext().getAccessibleName())));
    }

    @Test
    void aLessonLeadsFromThePredictionToItsNumbers() {
        begin();
        String wrong = "Only the front face, but narrower.";
        driver.click(driver.find(JRadioButton.class, wrong));
        driver.click(driver.find(JRadioButton.class, Texts.get("lesson.sure")));
        press("lesson.next.LOOK");
        driver.type(driver.find(JTextField.class, "Speed of the cube (c)"), "0.5");
        assertThat(speed()).isEqualTo(0.5);
        press("lesson.next.REASON");
        assertThat(WindowDriver.onEventThread(() -> shows(Texts.get("lesson.wrongSure"))))
                .isTrue();
        assertThat(speed()).isEqualTo(0.8);
        press("lesson.next.MEASURE");
        WindowDriver.await("the numbers", () -> shows("0.6") && shows(Texts.get("lesson.measured")));
        List<String> numbers = WindowDriver.onEventThread(
                () -> Components.showing(driver.window().frame(), JLabel.class)
                        .map(JLabel::getText)
                        .filter(text -> text.matches("[0-9.]+"))
                        .toList());
        // formula and measurement of both
        assertThat(numbers).hasSize(4);
        assertThat(Double.parseDouble(numbers.get(1))).isCloseTo(4.0 / 3, within(0.003));
        assertThat(Double.parseDouble(numbers.get(3))).isCloseTo(0.6, within(0.001));
    }

    /** The step that is marked is the one that is shown, also for the keys. */
    @Test
    void theArrowKeysGoFromPageToPage() {
        begin();
        driver.click(driver.find(JRadioButton.class, "Only the front face, but narrower."));
        driver.click(driver.find(JRadioButton.class, Texts.get("lesson.sure")));
        press("lesson.next.LOOK");
        press("lesson.next.REASON");
        driver.click(step("PREDICT"));
        for (String name : List.of("LOOK", "REASON")) {
            driver.key(KeyEvent.VK_RIGHT);
            JToggleButton reached = step(name);
            WindowDriver.await("the focus", reached::isFocusOwner);
            assertThat(reached.isSelected()).isTrue();
            assertThat(WindowDriver.onEventThread(() -> isShowing("Speed of the cube (c)")))
                    .as(name)
                    .isEqualTo(name.equals("LOOK"));
        }
        assertThat(WindowDriver.onEventThread(() -> shows(Texts.get("lesson.wrongSure"))))
                .isTrue();
    }

    private JToggleButton step(String name) {
        return driver.find(JToggleButton.class, Texts.get("lesson.step." + name));
    }

    private boolean isShowing(String field) {
        return Components.showing(driver.window().frame(), JTextField.class)
                .anyMatch(each -> field.equals(each.getAccessibleContext().getAccessibleName()));
    }

    private double speed() {
        return ((Moving) driver.studio().scene().get(0)).velocity().speed();
    }

    @Test
    void whoOnlyMovedTheSliderIsNotAskedToSave() {
        begin();
        JSlider slider = driver.find(JSlider.class, "Speed of the cube (c), slider");
        WindowDriver.onEventThread(() -> slider.setValue(700));
        assertThat(speed()).isCloseTo(0.665, within(1e-9));
        driver.menu(Studios.sphere().title());
        WindowDriver.await("the example", () -> driver.window().model().studio().equals(Studios.sphere()));
        JComponent again = driver.find(JMenu.class, "menu.lessons");
        assertThat(again.isEnabled()).isTrue();
        assertThat(Components.showing(driver.window().frame(), JSlider.class))
                .noneMatch(shown -> slider.getName().equals(shown.getName()));
    }

    @Test
    void chosenAgainItBeginsWithTheQuestion() {
        begin();
        driver.click(driver.find(JRadioButton.class, "Only the front face, but narrower."));
        driver.click(driver.find(JRadioButton.class, Texts.get("lesson.sure")));
        press("lesson.next.LOOK");
        driver.menu(cube.title());
        WindowDriver.await(
                "the question",
                () -> Components.find(driver.window().frame(), JRadioButton.class, Texts.get("lesson.sure"))
                        .isShowing());
        assertThat(driver.find(JRadioButton.class, Texts.get("lesson.sure")).isSelected())
                .isFalse();
    }
}
