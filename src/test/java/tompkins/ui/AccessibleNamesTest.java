package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.FocusTraversalPolicy;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.DefaultButtonModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JRadioButton;
import javax.swing.JSlider;
import javax.swing.JSplitPane;
import javax.swing.JToggleButton;
import javax.swing.JTree;
import javax.swing.plaf.basic.BasicSplitPaneDivider;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.widget.Texts;

/** Everything in the windows that can be used, or read with keys, has a name for screen readers, and Tab reaches it. */
class AccessibleNamesTest extends WindowFixture {

    @BeforeEach
    void open() throws Exception {
        Studio scene = BundledScenes.studio("fig4.json");
        driver = new WindowDriver(
                folder.resolve("settings"), scene.withSettings(scene.settings().withSize(64, 48)), null, List.of());
    }

    private void assertNamed() {
        Stream<Component> nameless =
                onEventThread(() -> Components.all(driver.window().frame())
                        .filter(Component::isShowing)
                        .filter(AccessibleNamesTest::isUsed)
                        .filter(each -> !hasName(each))
                        .toList()
                        .stream());
        assertThat(nameless.map(AccessibleNamesTest::describe)).isEmpty();
    }

    /** The Tab key reaches everything in the window below its menus; of buttons of which one is chosen, that one. */
    private void assertReached() {
        List<String> missed = onEventThread(() -> {
            JFrame frame = driver.window().frame();
            FocusTraversalPolicy policy = frame.getFocusTraversalPolicy();
            Set<Component> reached = new HashSet<>();
            Component next = policy.getFirstComponent(frame);
            while (reached.add(next)) {
                next = policy.getComponentAfter(frame, next);
            }
            return Components.all(frame.getContentPane())
                    .filter(each -> each.isShowing() && each.isEnabled() && each.isFocusable() && isUsed(each))
                    .filter(each -> !(each instanceof JSplitPane || each.getParent() instanceof JComboBox<?>))
                    // into one that can be typed into it goes at once
                    .filter(each -> !(each instanceof JComboBox<?> box && box.isEditable()))
                    .filter(each -> !reached.contains(each) && !(each instanceof JToggleButton && hasGroup(each)))
                    .map(AccessibleNamesTest::describe)
                    .toList();
        });
        assertThat(missed).isEmpty();
    }

    private static boolean hasGroup(Component button) {
        return ((AbstractButton) button).getModel() instanceof DefaultButtonModel model && model.getGroup() != null;
    }

    private static boolean isUsed(Component component) {
        return component instanceof JTextComponent text && text.isFocusable()
                || component instanceof AbstractButton button && button.isFocusable()
                || component instanceof JComboBox<?>
                || component instanceof JSlider
                || component instanceof JSplitPane
                || component instanceof JTree;
    }

    private static boolean hasName(Component component) {
        // what a combo box, a file chooser or a divider is made of belongs to them
        for (Component part = component; part != null; part = part.getParent()) {
            String name = part.getAccessibleContext() == null
                    ? null
                    : part.getAccessibleContext().getAccessibleName();
            if (name != null && !name.isBlank()) {
                return true;
            }
            if (!(part.getParent() instanceof JComboBox<?> || part.getParent() instanceof BasicSplitPaneDivider)) {
                return false;
            }
        }
        return false;
    }

    private static String describe(Component component) {
        return component.getClass().getName() + " " + component.getName() + " in "
                + component.getParent().getClass().getName() + " "
                + component.getParent().getName();
    }

    @Test
    void inThePanelTheBarsAndWithAPinnedRay() {
        assertNamed();
        assertReached();
        driver.menu("menu.ride");
        driver.menu("menu.ride");
        assertReached();
        driver.menu("menu.playPanel");
        driver.menu("menu.measure");
        onEventThread(() -> driver.window().view().setPin(new Point2D.Double(10, 10)));
        await("the story", () -> driver.showing(JComponent.class).anyMatch(each -> "ray.story".equals(each.getName())));
        assertNamed();
        assertReached();
    }

    @Test
    void inTheEditor() {
        driver.menu("menu.editScene");
        for (StudioPath part : List.of(
                StudioPath.ROOT,
                StudioPath.ROOT.then("scene").then(0),
                StudioPath.ROOT.then("cameraFrame").then(0),
                StudioPath.ROOT.then("lights").then(0))) {
            onEventThread(() -> driver.window().side.edit(part));
            assertNamed();
        }
    }

    @Test
    void onThePagesOfALesson() throws IOException {
        Studio lesson = BundledScenes.studio("lesson-02-turned-cube.json");
        Studio small = lesson.withSettings(lesson.settings().withSize(64, 48));
        driver.open(small, null);
        assertNamed();
        press(JRadioButton.class, "Only the front face, but narrower.");
        press(JRadioButton.class, Texts.get("lesson.sure"));
        for (String next : List.of("LOOK", "REASON", "MEASURE")) {
            press(JButton.class, Texts.get("lesson.next." + next));
            Components.enter(driver.window().frame(), "Speed of the cube (c)", "0.5");
            assertNamed();
            assertReached();
        }
    }

    private <B extends AbstractButton> void press(Class<B> type, String name) {
        B button = driver.find(type, name);
        onEventThread(() -> button.doClick());
    }

    @Test
    void inDocumentsMessagesQuestionsAndTheChart() {
        driver.menu("menu.tour");
        await("the tour", () -> driver.showing(JEditorPane.class).findAny().isPresent());
        assertNamed();
        driver.menu("menu.cite");
        await(
                "the reference",
                () -> Components.messages(driver.window().frame()).findAny().isPresent());
        assertNamed();
        driver.answer("Close");
        driver.menu("menu.savePhotograph");
        JFileChooser chooser = driver.chooser();
        assertNamed();
        onEventThread(chooser::cancelSelection);
        driver.menu("menu.quality");
        assertNamed();
    }
}
