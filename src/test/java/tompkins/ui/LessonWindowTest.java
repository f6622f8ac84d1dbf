package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButton;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.Waiting;
import tompkins.io.BundledScenes;
import tompkins.lesson.Lesson;
import tompkins.sceneobject.Moving;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.picture.Pictures;
import tompkins.ui.widget.Texts;

class LessonWindowTest extends WindowFixture {

    private Studio cube;

    @BeforeEach
    void open() throws IOException {
        Studio scene = BundledScenes.studio("lesson-02-turned-cube.json");
        cube = scene.withSettings(scene.settings().withSize(80, 60));
        driver = new WindowDriver(folder.resolve("settings"), Studios.sphere(), null, List.of(Studios.sphere(), cube));
        await(
                "the lessons",
                () -> Components.all(driver.window().frame())
                        .anyMatch(item -> cube.title().equals(item.getName())));
        driver.completePicture();
    }

    private void begin() {
        driver.menu(cube.title());
        await("the lesson", () -> driver.studio().equals(cube));
        driver.completePicture();
    }

    private void press(String key) {
        driver.click(driver.find(JButton.class, Texts.get(key)));
    }

    private boolean shows(String text) {
        return driver.showing(JLabel.class).anyMatch(label -> text.equals(label.getText()));
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

    /** Together they would leave no room for the picture. */
    @Test
    void oneTabIsOpenAtATime() {
        Map<String, String> tabs = new LinkedHashMap<>();
        tabs.put("menu.ride", "ride.home");
        tabs.put("menu.playPanel", "play.loop");
        tabs.put("menu.measure", "measure.copy");
        assertThat(isShown("strip.close")).isFalse();
        tabs.forEach((item, button) -> {
            driver.menu(item);
            assertThat(tabs.values()).filteredOn(this::isShown).containsExactly(button);
        });
        begin();
        assertThat(tabs.values()).as("beside the question").noneMatch(this::isShown);
        assertThat(isShown("lesson.again")).isTrue();
        driver.menu("menu.measure");
        assertThat(isShown("lesson.again")).isTrue();
    }

    private boolean isShown(String button) {
        return onEventThread(() -> driver.showing(JComponent.class)
                .anyMatch(each ->
                        Texts.get(button).equals(each.getAccessibleContext().getAccessibleName())));
    }

    /** Waits until the first prediction has the keys. */
    private JRadioButton awaitKeys() {
        String text = ((Lesson) cube.lesson()).shuffled().get(0).text();
        JRadioButton first = driver.find(JRadioButton.class, text);
        await("the keys at the first prediction", first::isFocusOwner);
        return first;
    }

    /** As one that is chosen from the menu; the menus come later. */
    @Test
    void aLessonThatOpensTheWindowHasKeysAndPlace() {
        driver.close();
        driver = new WindowDriver(folder.resolve("other"), cube, null, List.of(Studios.sphere(), cube));
        awaitKeys();
        await("its place", () -> shows("1 of 1, 0 done"));
    }

    @Test
    void enterLeadsFromPageToPage() {
        begin();
        awaitKeys();
        driver.key(KeyEvent.VK_ENTER);
        assertThat(step("LOOK").isEnabled()).as("without an answer").isFalse();
        driver.key(KeyEvent.VK_SPACE);
        driver.key(KeyEvent.VK_TAB);
        driver.key(KeyEvent.VK_SPACE);
        enter("LOOK");
        driver.key(KeyEvent.VK_END);
        assertThat(speed()).isEqualTo(0.95);
        enter("REASON");
        enter("MEASURE");
    }

    private void enter(String page) {
        driver.key(KeyEvent.VK_ENTER);
        assertThat(step(page).isSelected()).as(page).isTrue();
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
        assertThat(onEventThread(() -> shows(Texts.get("lesson.wrongSure")))).isTrue();
        assertThat(speed()).isEqualTo(0.8);
        press("lesson.next.MEASURE");
        await("the numbers", () -> notes().anyMatch(text -> text.startsWith("Measured")));
        assertThat(drawnMarks()).as("where that was").isGreaterThan(50);
        driver.click(step("REASON"));
        assertThat(drawnMarks()).isZero();
    }

    private Stream<String> notes() {
        return driver.showing(JTextArea.class).map(JTextArea::getText);
    }

    /** Pixels of the canvas in the colour of marks. */
    private long drawnMarks() {
        return onEventThread(
                () -> IntStream.of(Pictures.painted(driver.window().view().canvas()))
                        .filter(pixel -> (pixel & 0xffffff) == 0x78ffff)
                        .count());
    }

    /** The step that is marked is the one that is shown, also for the keys. */
    @Test
    void theArrowKeysGoFromPageToPage() {
        begin();
        driver.click(driver.find(JRadioButton.class, "Only the front face, but narrower."));
        driver.click(driver.find(JRadioButton.class, Texts.get("lesson.sure")));
        press("lesson.next.LOOK");
        driver.type(driver.find(JTextField.class, "Speed of the cube (c)"), "0.5");
        press("lesson.next.REASON");
        driver.click(step("PREDICT"));
        for (String name : List.of("LOOK", "REASON")) {
            driver.key(KeyEvent.VK_RIGHT);
            JToggleButton reached = step(name);
            await("the focus", reached::isFocusOwner);
            assertThat(reached.isSelected()).isTrue();
            assertThat(onEventThread(() -> isShowing("Speed of the cube (c)")))
                    .as(name)
                    .isTrue();
        }
        assertThat(onEventThread(() -> shows(Texts.get("lesson.wrongSure")))).isTrue();
    }

    /** A tap is over before the button that is turned off by it has got the keys. */
    @Test
    void afterATapTheKeysMoveTheSlider() {
        begin();
        driver.click(driver.find(JRadioButton.class, "Only the front face, but narrower."));
        driver.click(driver.find(JRadioButton.class, Texts.get("lesson.sure")));
        JButton next = driver.find(JButton.class, Texts.get("lesson.next.LOOK"));
        onEventThread(() -> IntStream.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED)
                .forEach(id -> Components.mouse(next, id, 5, 5)));
        JSlider slider = Components.find(
                driver.find(JScrollPane.class, "panel"), JSlider.class, "Speed of the cube (c), slider");
        await("the focus", slider::isFocusOwner);
        driver.key(KeyEvent.VK_END);
        assertThat(speed()).isEqualTo(0.95);
    }

    private JToggleButton step(String name) {
        return driver.find(JToggleButton.class, Texts.get("lesson.step." + name));
    }

    private boolean isShowing(String field) {
        return Components.showing(driver.find(JScrollPane.class, "panel"), JTextField.class)
                .anyMatch(each -> field.equals(each.getAccessibleContext().getAccessibleName()));
    }

    private double speed() {
        return ((Moving) driver.studio().scene().get(0)).velocity().speed();
    }

    @Test
    void whoOnlyMovedTheSliderIsNotAskedToSave() {
        driver.open(cube, folder.resolve("cube.json"));
        JSlider slider = driver.find(JSlider.class, "Speed of the cube (c), slider");
        onEventThread(() -> slider.setValue(700));
        assertThat(speed()).isCloseTo(0.665, within(1e-9));
        driver.menu(Studios.sphere().title());
        await("the example", () -> driver.studio().equals(Studios.sphere()));
    }

    /** The sheet of the lesson that is open, with its answers in a second file. */
    @Test
    void aSheetIsSavedFromTheMenu() throws IOException {
        begin();
        driver.menu("menu.lessonSheet");
        JScrollPane accessory = (JScrollPane) driver.chooser().getAccessory();
        JList<?> lessons = (JList<?>) accessory.getViewport().getView();
        assertThat(onEventThread(lessons::getSelectedValue)).isEqualTo(cube.title());
        driver.choose(folder.resolve("cube"));
        Path answers = folder.resolve("cube-answers.html");
        Waiting.until("the answers", () -> Files.exists(answers));
        assertThat(Files.readString(folder.resolve("cube.html"))).contains(cube.title(), "Speed of the cube (c): 0.8");
        assertThat(Files.readString(answers)).contains("&#x2611; <b>Front and trailing face, as if turned.</b>");
    }
}
