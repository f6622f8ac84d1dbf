package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.io.StudioReader;
import tompkins.property.Descriptions;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studios;
import tompkins.surface.PictureSurface;
import tompkins.surface.Surface;
import tompkins.ui.widget.Texts;

class EditorWindowTest extends WindowFixture {

    private Path file;

    @BeforeEach
    void open() {
        file = folder.resolve("sphere.json");
        driver = new WindowDriver(folder.resolve("settings"), Studios.sphere(), file, List.of());
        driver.menu("menu.editScene");
        await("the editor", this::isOpen);
        JTree tree = driver.find(JTree.class, "tree");
        onEventThread(() -> {
            // the scene, and in it the sphere
            tree.expandRow(1);
            tree.setSelectionRow(2);
        });
    }

    private boolean isOpen() {
        return driver.window().side.isEditing();
    }

    /** Swing finds no line in it, whose beginning would be the place of the caret. */
    @Test
    void textWithoutRoomSurvivesKeys() {
        JTextField field = radius();
        driver.click(field);
        // nothing that the window shows meanwhile may give the field its size back
        onEventThread(() -> field.getParent().setLayout(null));
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        onEventThread(
                () -> Thread.currentThread().setUncaughtExceptionHandler((thread, failure) -> failures.add(failure)));
        for (Dimension none : List.of(new Dimension(0, 0), new Dimension(field.getWidth(), 1), new Dimension(1, 20))) {
            onEventThread(() -> field.setSize(none));
            for (int key : List.of(KeyEvent.VK_HOME, KeyEvent.VK_END, KeyEvent.VK_LEFT, KeyEvent.VK_UP)) {
                driver.key(key);
                driver.key(key, KeyEvent.VK_SHIFT);
            }
            assertThat(field.getSize()).as("not laid out anew").isEqualTo(none);
        }
        assertThat(field.isFocusOwner()).isTrue();
        onEventThread(() -> Thread.currentThread().setUncaughtExceptionHandler(null));
        assertThat(failures).isEmpty();
    }

    private JTextField radius() {
        return driver.find(JTextField.class, "Radius");
    }

    private double radiusOfTheSphere() {
        return ((Sphere) driver.studio().scene().get(0)).radius();
    }

    /** A split pane would take this key to go from the tree to the form. */
    @Test
    void rideBeginsAndPausesFromTheEditor() {
        for (boolean riding : new boolean[] {true, false}) {
            driver.key(KeyEvent.VK_F6);
            await("riding: " + riding, () -> driver.pilot().isRiding() == riding);
        }
    }

    /** A field that still has the focus is no reason to leave its value out of the file. */
    @Test
    void typedWithoutEnterIsSavedOrRefusedAloud() {
        driver.typeWithoutEnter(radius(), "0.25");
        driver.key(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
        await("the saved scene", () -> driver.said().equals("Saved " + file));
        assertThat(((Sphere) StudioReader.read(file).scene().get(0)).radius()).isEqualTo(0.25);

        driver.typeWithoutEnter(radius(), "-1");
        driver.key(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
        await(
                "the remark",
                () -> driver.said().equals("Saved " + file + ", without the values that are marked as wrong"));
        assertThat(Components.isMarked(radius())).isTrue();
        assertThat(StudioReader.read(file)).isEqualTo(driver.studio());

        // and it is put right before another object is chosen
        JTree tree = driver.find(JTree.class, "tree");
        onEventThread(() -> tree.requestFocusInWindow());
        await("the focus", tree::isFocusOwner);
        onEventThread(() -> tree.setSelectionRow(1));
        await("the focus on the wrong value", () -> radius().isFocusOwner());
        assertThat(tree.getSelectionRows()).containsExactly(2);
    }

    @Test
    void picturesAreChosenFromTheFolderOfTheScene() throws IOException {
        driver.set(Studios.sphere().withScene(List.of(pictured(PictureSurface.DEFAULT))));
        Path wrong = Files.writeString(folder.resolve("wrong.png"), "no picture");
        choosePicture(wrong);
        await(
                "the refusal",
                () -> driver.showing(JTextArea.class)
                        .anyMatch(text -> text.getText().contains("wrong.png: not a picture")));
        assertThat(driver.studio().scene()).containsExactly(pictured(PictureSurface.DEFAULT));

        Path right = folder.resolve("right.png");
        ImageIO.write(new BufferedImage(7, 5, BufferedImage.TYPE_INT_RGB), "png", right.toFile());
        choosePicture(right);
        await("the picture", () -> picture().width() == 7);
        assertThat(picture().height()).isEqualTo(5);
    }

    private static Sphere pictured(Surface surface) {
        return Descriptions.with(Sphere.DEFAULT, "surface", surface);
    }

    private PixelPicture picture() {
        Sphere sphere = (Sphere) driver.studio().scene().get(0);
        return ((PictureSurface) sphere.surface()).picture();
    }

    private void choosePicture(Path picture) {
        WindowDriver.later(driver.find(JButton.class, "Picture")::doClick);
        assertThat(driver.chooser().getCurrentDirectory()).isEqualTo(folder.toFile());
        driver.choose(picture);
    }

    @Test
    void anOpenMenuTakesTheKeysAndEscapeFirst() {
        driver.type(radius(), "0.25");
        JTree tree = driver.find(JTree.class, "tree");
        onEventThread(() -> tree.setSelectionRow(1));
        driver.click(driver.find(JButton.class, Texts.get("tree.add")));
        await("the menu", EditorWindowTest::isMenuOpen);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(radiusOfTheSphere()).isEqualTo(0.25);
        driver.key(KeyEvent.VK_ESCAPE);
        await("the end of the menu", () -> !isMenuOpen());
        assertThat(isOpen()).isTrue();
    }

    private static boolean isMenuOpen() {
        return MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
    }
}
