package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.StudioReader;
import tompkins.property.Descriptions;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.PictureSurface;
import tompkins.surface.Surface;
import tompkins.ui.widget.Texts;

/** The keys of the window with the tree of the scene. */
@Timeout(600)
@NeedsDisplay
class EditorWindowTest {

    @TempDir
    private Path folder;

    private Path file;

    @AutoClose
    private WindowDriver driver;

    @BeforeEach
    void open() {
        file = folder.resolve("sphere.json");
        driver = new WindowDriver(folder.resolve("settings"), Studios.sphere(), file, List.of());
        driver.menu("menu.editScene");
        WindowDriver.await("the editor", this::isOpen);
        JTree tree = driver.find(JTree.class, "tree");
        WindowDriver.onEventThread(() -> {
            // the scene, and in it the sphere
            tree.expandRow(1);
            tree.setSelectionRow(2);
        });
    }

    private boolean isOpen() {
        return driver.window().side.isEditing();
    }

    @Test
    void aNewSceneIsBegunWhereObjectsAreAdded() {
        JTree tree = driver.find(JTree.class, "tree");
        WindowDriver.onEventThread(() -> {
            // the last line, which has nothing to add
            tree.setSelectionRow(tree.getRowCount() - 1);
            driver.window().side.setEditing(false);
        });
        driver.menu("menu.new");
        WindowDriver.await("the editor", this::isOpen);
        assertThat(driver.studio()).isEqualTo(Studio.DEFAULT);
        assertThat(driver.find(JButton.class, Texts.get("tree.add")).isEnabled())
                .isTrue();
        driver.key(KeyEvent.VK_F1);
        WindowDriver.await(
                "the keys",
                () -> Components.showing(driver.window().frame(), JDialog.class)
                        .findAny()
                        .isPresent());
        driver.key(KeyEvent.VK_ESCAPE);
    }

    @Test
    void aRefusedValueIsTakenBackByEscape() {
        driver.type(radius(), "-1");
        assertThat(Components.isMarked(radius())).isTrue();
        driver.key(KeyEvent.VK_ESCAPE);
        assertThat(Components.isMarked(radius())).isFalse();
        assertThat(isOpen()).isTrue();
    }

    /** Swing finds no line in it, whose beginning would be the place of the caret. */
    @Test
    void textWithoutRoomSurvivesKeys() {
        JTextField field = radius();
        driver.click(field);
        // nothing that the window shows meanwhile may give the field its size back
        WindowDriver.onEventThread(() -> field.getParent().setLayout(null));
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        WindowDriver.onEventThread(
                () -> Thread.currentThread().setUncaughtExceptionHandler((thread, failure) -> failures.add(failure)));
        for (Dimension none : List.of(new Dimension(0, 0), new Dimension(field.getWidth(), 1), new Dimension(1, 20))) {
            WindowDriver.onEventThread(() -> field.setSize(none));
            for (int key : List.of(KeyEvent.VK_HOME, KeyEvent.VK_END, KeyEvent.VK_LEFT, KeyEvent.VK_UP)) {
                driver.key(key);
                driver.key(key, KeyEvent.VK_SHIFT);
            }
            assertThat(field.getSize()).as("not laid out anew").isEqualTo(none);
        }
        assertThat(field.isFocusOwner()).isTrue();
        WindowDriver.onEventThread(() -> Thread.currentThread().setUncaughtExceptionHandler(null));
        assertThat(failures).isEmpty();
    }

    private JTextField radius() {
        return driver.find(JTextField.class, "Radius");
    }

    private double radiusOfTheSphere() {
        return ((Sphere) driver.studio().scene().get(0)).radius();
    }

    @Test
    void menuKeysUndoRedoAndSaveWhatWasTyped() {
        driver.type(radius(), "0.25");
        assertThat(radiusOfTheSphere()).isEqualTo(0.25);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
        assertThat(radiusOfTheSphere()).isEqualTo(0.25);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        driver.key(KeyEvent.VK_Y, KeyEvent.VK_CONTROL);
        assertThat(radiusOfTheSphere()).isEqualTo(0.25);
        driver.key(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
        WindowDriver.await("the saved scene", () -> !driver.window().model().isModified());
        assertThat(StudioReader.read(file)).isEqualTo(driver.studio());
    }

    /** A split pane would take this key to go from the tree to the form. */
    @Test
    void rideBeginsAndPausesFromTheEditor() {
        for (boolean riding : new boolean[] {true, false}) {
            driver.key(KeyEvent.VK_F6);
            WindowDriver.await(
                    "riding: " + riding, () -> driver.window().motion.pilot().isRiding() == riding);
        }
    }

    /** A field that still has the focus is no reason to leave its value out of the file. */
    @Test
    void typedWithoutEnterIsSavedOrRefusedAloud() {
        driver.typeWithoutEnter(radius(), "0.25");
        driver.key(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
        WindowDriver.await("the saved scene", () -> said().equals("Saved " + file));
        assertThat(((Sphere) StudioReader.read(file).scene().get(0)).radius()).isEqualTo(0.25);

        driver.typeWithoutEnter(radius(), "-1");
        driver.key(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
        WindowDriver.await(
                "the remark", () -> said().equals("Saved " + file + ", without the values that are marked as wrong"));
        assertThat(Components.isMarked(radius())).isTrue();
        assertThat(StudioReader.read(file)).isEqualTo(driver.studio());
    }

    private String said() {
        return Components.find(driver.window().frame(), JLabel.class, "status.what")
                .getText();
    }

    /** As long as the editor is there a click chooses, except while clicks measure. */
    @Test
    void theLineAtTheBottomSaysWhatAClickDoes() {
        WindowDriver.await("choosing", () -> said().equals("Click to choose an object or a lamp."));
        driver.menu("menu.measure");
        WindowDriver.await("measuring", () -> said().equals("Click in the picture to measure there."));
        driver.menu("menu.measure");
        WindowDriver.await("choosing again", () -> said().startsWith("Click to choose"));
        WindowDriver.onEventThread(() -> driver.window().side.setEditing(false));
        WindowDriver.await("pinning", () -> said().equals(Texts.get("status.idle.PIN")));
    }

    @Test
    void picturesAreChosenFromTheFolderOfTheScene() throws IOException {
        WindowDriver.onEventThread(() ->
                driver.window().model().set(Studios.sphere().withScene(List.of(pictured(PictureSurface.DEFAULT)))));
        Path wrong = Files.writeString(folder.resolve("wrong.png"), "no picture");
        choosePicture(wrong);
        WindowDriver.await(
                "the refusal",
                () -> Components.showing(driver.window().frame(), JTextArea.class)
                        .anyMatch(text -> text.getText().contains("wrong.png: not a picture")));
        assertThat(driver.studio().scene()).containsExactly(pictured(PictureSurface.DEFAULT));

        Path right = folder.resolve("right.png");
        ImageIO.write(new BufferedImage(7, 5, BufferedImage.TYPE_INT_RGB), "png", right.toFile());
        choosePicture(right);
        WindowDriver.await("the picture", () -> picture().width() == 7);
        assertThat(picture().height()).isEqualTo(5);
    }

    private static Sphere pictured(Surface surface) {
        return Descriptions.with(Sphere.DEFAULT, "surface", surface);
    }

    private PixelPicture picture() {
        Sphere sphere = (Sphere) driver.window().model().studio().scene().get(0);
        return ((PictureSurface) sphere.surface()).picture();
    }

    private void choosePicture(Path picture) {
        WindowDriver.later(driver.find(JButton.class, "Picture")::doClick);
        assertThat(driver.chooser().getCurrentDirectory()).isEqualTo(folder.toFile());
        driver.choose(picture);
    }

    @Test
    void undoTakesBackWhatWasRefused() {
        driver.type(radius(), "0.25");
        driver.type(radius(), "-1");
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(Components.isMarked(radius())).isFalse();
        assertThat(radiusOfTheSphere()).isEqualTo(0.25);
    }

    @Test
    void aWrongValueIsPutRightBeforeAnotherObjectIsChosen() {
        JTree tree = driver.find(JTree.class, "tree");
        JTextField radius = radius();
        driver.type(radius, "-1");
        click(tree, 1);
        WindowDriver.await("the focus on the wrong value", radius::isFocusOwner);
        assertThat(Components.isMarked(radius)).isTrue();
        assertThat(tree.getSelectionRows()).containsExactly(2);
        driver.key(KeyEvent.VK_ESCAPE);
        click(tree, 1);
        WindowDriver.await("the other object", () -> tree.isRowSelected(1) && !radius.isShowing());
    }

    private void click(JTree tree, int row) {
        driver.click(WindowDriver.onEventThread(() -> {
            Point corner = tree.getLocationOnScreen();
            Rectangle line = tree.getRowBounds(row);
            return new Point(corner.x + (int) line.getCenterX(), corner.y + (int) line.getCenterY());
        }));
    }

    @Test
    void anOpenMenuTakesTheKeysAndEscapeFirst() {
        driver.type(radius(), "0.25");
        JTree tree = driver.find(JTree.class, "tree");
        WindowDriver.onEventThread(() -> tree.setSelectionRow(1));
        driver.click(driver.find(JButton.class, Texts.get("tree.add")));
        WindowDriver.await("the menu", EditorWindowTest::isMenuOpen);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(radiusOfTheSphere()).isEqualTo(0.25);
        driver.key(KeyEvent.VK_ESCAPE);
        WindowDriver.await("the end of the menu", () -> !isMenuOpen());
        assertThat(isOpen()).isTrue();
    }

    private static boolean isMenuOpen() {
        return MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
    }
}
