package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JTextPane;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.Thorough;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Screens;
import tompkins.ui.widget.Texts;

class WindowQuestionsTest extends WindowFixture {

    /** A wall 8 in front of the camera, which is focused at 10. */
    private static final Studio WALL = Studio.DEFAULT
            .withScene(
                    List.of(new Plane("wall", new Vector3d(0, 0, 8), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT)))
            .withSettings(Studio.DEFAULT.settings().withSize(64, 48));

    private static final int MOST_BORDERS = 60;

    private Path file;

    @BeforeEach
    void open() throws IOException {
        file = folder.resolve("wall.json");
        StudioWriter.save(WALL, file, true);
        driver = new WindowDriver(folder.resolve("settings"), WALL, file, List.of(Studios.sphere()));
        await(
                "the examples",
                () -> Components.all(driver.window().frame())
                        .anyMatch(item -> Studios.sphere().title().equals(item.getName())));
        driver.completePicture();
    }

    private String title() {
        return onEventThread(() -> driver.window().frame().getTitle());
    }

    private boolean isOpen() {
        return onEventThread(() -> driver.window().frame().isDisplayable());
    }

    private void change() {
        driver.type(driver.find(JTextField.class, "Speed"), "0.5");
        assertThat(title()).startsWith("\u2022 ");
    }

    @Test
    void closingWithChangesAsksAndCanBeCancelled() throws IOException {
        String before = Files.readString(file);
        assertThat(title()).isEqualTo("Untitled \u2013 wall.json \u2013 Tompkins");
        change();
        driver.menu("menu.close");
        driver.answer("Cancel");
        assertThat(isOpen()).isTrue();
        assertThat(driver.studio().velocity().speed()).isEqualTo(0.5);
        driver.menu("menu.close");
        driver.answer("Discard");
        await("the end", () -> !driver.window().frame().isDisplayable());
        assertThat(Files.readString(file)).isEqualTo(before);
    }

    @Test
    void aSceneWithoutAFileIsGivenOneBeforeItIsLeft() {
        driver.menu(Studios.sphere().title());
        await("the example", () -> driver.studio().equals(Studios.sphere()));
        change();
        Studio changed = driver.studio();
        driver.menu("menu.close");
        driver.answer("Save");
        driver.choose(folder.resolve("sphere"));
        await("the end", () -> !driver.window().frame().isDisplayable());
        assertThat(StudioReader.read(folder.resolve("sphere.json"))).isEqualTo(changed);
    }

    @Test
    void anExistingFileIsReplacedOnlyWhenTheUserAgrees() throws IOException {
        Path photograph = Files.writeString(folder.resolve("mine.png"), "mine");
        driver.menu("menu.savePhotograph");
        driver.choose(photograph);
        driver.answer("Cancel");
        // another name may be chosen
        await("the file chooser again", driver::isChooserOpen);
        assertThat(Files.readString(photograph)).isEqualTo("mine");
        driver.choose(photograph);
        driver.answer("OK");
        await("the photograph", () -> driver.said().startsWith("Saved"));
        String scene = PhotographFile.readScene(photograph).orElseThrow();
        assertThat(StudioReader.read(scene, "mine.png", folder)).isEqualTo(WALL);
    }

    @Test
    void theWindowStaysOpenOnlyWhileAnExportRuns() throws IOException {
        driver.open(Studios.slow(), null);
        driver.menu("menu.playPanel");
        driver.answer(Texts.get("play.export"));
        Path film = folder.resolve("film.gif");
        driver.choose(film);
        await("the progress", () -> task().findAny().isPresent());
        driver.menu("menu.close");
        driver.answer(Texts.get("close.wait"));
        assertThat(isOpen()).isTrue();
        driver.answer("Cancel");
        await("the end of the work", () -> task().findAny().isEmpty());
        try (Stream<Path> left = Files.list(folder)) {
            assertThat(left.filter(Files::isRegularFile)).containsExactly(file);
        }
        assertThat(driver.said()).isEqualTo("Cancelled: " + film + " was not saved.");
        driver.key(KeyEvent.VK_Q, KeyEvent.VK_CONTROL);
        await("the end", () -> !driver.window().frame().isDisplayable());
    }

    @Test
    void windowsAreNotLargerThanTheirScreen() throws IOException {
        driver.close();
        Files.writeString(
                Files.createDirectories(folder.resolve("settings")).resolve("window.properties"),
                "width=9000\nheight=8000\n");
        driver = new WindowDriver(folder.resolve("settings"), WALL, file, List.of());
        assertThat(onEventThread(() -> fills(driver.window().frame()))).isTrue();
        JDialog dialog = onEventThread(() -> {
            JDialog made = new JDialog(driver.window().frame());
            made.setSize(5000, 4000);
            made.setVisible(true);
            return made;
        });
        await("the size of the screen", () -> fills(dialog));
        onEventThread(dialog::dispose);
    }

    /** Whether a window takes all of its screen, but for the borders of a window manager. */
    private static boolean fills(Window window) {
        Rectangle room = Screens.room(window);
        int left = room.width - window.getWidth();
        int below = room.height - window.getHeight();
        return left >= 0 && left < MOST_BORDERS && below >= 0 && below < MOST_BORDERS;
    }

    @Test
    void thePanelIsAsWideAsLargeTypeNeeds() {
        driver.open(Studio.DEFAULT, null);
        driver.enlarge();
        JScrollPane panel = driver.find(JScrollPane.class, "panel");
        int before = onEventThread(panel::getWidth);
        driver.menu("look.PROJECTOR");
        await("larger type", () -> panel.getWidth() > before);
        assertThat(onEventThread(() -> panel.getViewport().getView().getMinimumSize().width))
                .isLessThanOrEqualTo(onEventThread(() -> panel.getViewport().getWidth()));
        driver.menu("look.LIGHT");
        await("the first width", () -> panel.getWidth() == before);
    }

    /** An animation that went on behind the question would leave changes for ever. */
    @Test
    void aSceneThatPlaysIsSavedBeforeTheWindowCloses() {
        change();
        driver.key(KeyEvent.VK_F9);
        await("the animation", () -> driver.studio().velocity().speed() != 0.5);
        driver.menu("menu.close");
        driver.answer("Save");
        await("the end", () -> !driver.window().frame().isDisplayable());
        assertThat(StudioReader.read(file)).isEqualTo(driver.studio());
    }

    @Test
    void whatTheTabKeyReachesComesIntoView() {
        JScrollPane panel = driver.find(JScrollPane.class, "panel");
        makeLow();
        JTextField exposure = driver.find(JTextField.class, "Exposure");
        assertThat(isInView(panel, exposure)).isFalse();
        driver.click(driver.find(JTextField.class, "Speed"));
        for (int tab = 0; tab < 40 && !onEventThread(exposure::isFocusOwner); tab++) {
            driver.key(KeyEvent.VK_TAB);
        }
        assertThat(onEventThread(exposure::isFocusOwner)).isTrue();
        await("the field", () -> isInView(panel, exposure));
        // who uses the mouse looks at what is new, and not at what has the focus
        driver.click(exposure);
        driver.open(Descriptions.with(Studios.sphere(), "remarks", "Look at this."), null);
        await("the remarks", () -> panel.getVerticalScrollBar().getValue() == 0);
    }

    /** Too low for all of the panel. */
    private void makeLow() {
        onEventThread(() -> {
            driver.window().frame().setSize(900, 400);
            driver.window().frame().validate();
        });
    }

    private static boolean isInView(JScrollPane pane, JComponent part) {
        Rectangle place = SwingUtilities.convertRectangle(
                part.getParent(), part.getBounds(), pane.getViewport().getView());
        return part.isShowing() && pane.getViewport().getViewRect().contains(place);
    }

    /** The old picture must not pass for that of the scene. */
    @Test
    void aSceneThatCannotBePicturedSaysSoUntilItCan() {
        JLabel picture = driver.find(JLabel.class, "status.picture");
        Sphere huge = new Sphere("sphere", new Vector3d(0, 0, 10), 1e200, ColouredSurface.DEFAULT);
        driver.set(WALL.withScene(List.of(huge)));
        await("the message", () -> driver.said().contains("scene[0]"));
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        driver.move(driver.centre(canvas));
        assertThat(driver.said()).contains("scene[0]");
        assertThat(onEventThread(picture::getText)).isEqualTo("still showing the previous picture");
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        await("the picture of the wall", () -> picture.getText().contains("1 sample per pixel"));
        assertThat(driver.said()).doesNotContain("scene[0]");
    }

    private Stream<JDialog> task() {
        return driver.showing(JDialog.class).filter(dialog -> "task".equals(dialog.getName()));
    }

    @Test
    void thePinnedRayHasAPlaceOfItsOwn() {
        JTextField speed = driver.find(JTextField.class, "Speed");
        Point before = onEventThread(speed::getLocationOnScreen);
        driver.click(driver.find(PictureCanvas.class, "picture"));
        JTextPane story = driver.find(JTextPane.class, "ray.story");
        JScrollPane panel = driver.find(JScrollPane.class, "panel");
        await("the story of the ray", story::isShowing);
        assertThat(onEventThread(speed::getLocationOnScreen)).isEqualTo(before);
        assertThat(isInView(panel, speed)).isTrue();
        String first = onEventThread(() -> story.getText());
        onEventThread(() -> panel.getVerticalScrollBar().setValue(20));

        Point middle = driver.centre(driver.find(PictureCanvas.class, "picture"));
        driver.click(new Point(middle.x + 60, middle.y));
        await("another story", () -> !story.getText().equals(first));
        assertThat(onEventThread(() -> panel.getVerticalScrollBar().getValue())).isEqualTo(20);

        driver.click(driver.find(JButton.class, "Unpin"));
        await("the end of the ray", () -> !story.isShowing());
        assertThat(isInView(panel, speed)).isTrue();
    }

    @Test
    @Thorough
    void theNumbersOfThePinnedRayCanBeCopied() throws IOException, UnsupportedFlavorException {
        driver.click(driver.find(PictureCanvas.class, "picture"));
        JTextPane story = driver.find(JTextPane.class, "ray.story");
        await("the story of the ray", story::isShowing);
        driver.click(story);
        driver.key(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
        driver.key(KeyEvent.VK_C, KeyEvent.VK_CONTROL);
        assertThat(Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor))
                .isEqualTo(story.getText())
                .asString()
                .startsWith("Pixel ");
        driver.key(KeyEvent.VK_TAB);
        assertThat(driver.find(JButton.class, "Edit").isFocusOwner()).isTrue();
    }

    @Test
    void menusHaveLettersAndAllKeysAreSeenAtOnce() {
        JMenuBar bar = driver.window().frame().getJMenuBar();
        assertThat(Components.all(bar)
                        .filter(part -> part.getParent() == bar)
                        .filter(JMenu.class::isInstance)
                        .map(menu -> ((JMenu) menu).getMnemonic()))
                .hasSize(7)
                .doesNotHaveDuplicates()
                .doesNotContain(0);
        List<String> keys = accelerators();
        assertThat(keys).hasSizeGreaterThan(10).contains("Ctrl+Shift+Z", "F1");
        driver.key(KeyEvent.VK_F1);
        await("the keys", () -> driver.showing(JPanel.class).anyMatch(panel -> "keys".equals(panel.getName())));
        JPanel table = driver.find(JPanel.class, "keys");
        assertThat(Components.labels(table)).containsAll(keys);
        // a laptop has room for 55 lines of type, of which the frame of the message takes 12, and a task bar 2
        assertThat(table.getPreferredSize().height).isLessThanOrEqualTo(Look.pixels(41));
        await("the keys that scroll", table::isFocusOwner);
        driver.answer("OK");
    }

    private List<String> accelerators() {
        return onEventThread(() -> Components.all(driver.window().frame())
                .filter(JMenuItem.class::isInstance)
                .map(item -> ((JMenuItem) item).getAccelerator())
                .filter(key -> key != null)
                .map(key ->
                        InputEvent.getModifiersExText(key.getModifiers()) + "+" + KeyEvent.getKeyText(key.getKeyCode()))
                .map(key -> key.replaceFirst("^[+]", ""))
                .toList());
    }
}
