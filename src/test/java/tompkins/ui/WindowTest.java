package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.JTextPane;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.Thorough;
import tompkins.Waiting;
import tompkins.io.SelfDescription;
import tompkins.io.StudioWriter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.RenderController;

class WindowTest extends WindowFixture {

    @BeforeEach
    void open() throws IOException {
        Path file = folder.resolve("lattice.json");
        Studio studio = Studios.lattice().withSettings(Studio.DEFAULT.settings().withSize(320, 240));
        StudioWriter.save(studio, file, true);
        driver = new WindowDriver(folder, studio, file, List.of());
    }

    @Test
    void draggingTheSpeedSliderChangesTheSpeedInOneStep() {
        JSlider slider = driver.find(JSlider.class, "Speed, slider");
        Velocity before = driver.studio().velocity();
        Point middle = driver.centre(slider);
        int left = onEventThread(() -> slider.getLocationOnScreen().x);
        double share = 0.8 * before.rapidity() / 3;
        int knob = left + 8 + (int) (share * (slider.getWidth() - 16));
        driver.drag(new Point(knob, middle.y), new Point(left - 20, middle.y), 30);
        assertThat(driver.studio().velocity().isRest())
                .as("exactly at rest at the left end")
                .isTrue();
        assertThat(driver.completePicture().plan().isAtRest()).isTrue();
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio().velocity()).isEqualTo(before);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
        assertThat(driver.studio().velocity().isRest()).isTrue();
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        driver.key(KeyEvent.VK_Y, KeyEvent.VK_CONTROL);
        assertThat(driver.studio().velocity().isRest()).isTrue();
    }

    @Test
    @Thorough
    void theCitationIsCopied() throws Exception {
        driver.menu("menu.cite");
        driver.answer("Copy BibTeX");
        await("the answer", () -> driver.said().equals("The citation is on the clipboard."));
        String copied =
                (String) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
        assertThat(copied)
                .startsWith("@software{tompkins,\n")
                .endsWith("}\n")
                .contains("  version = {" + SelfDescription.version() + "},\n", "  doi = {10.1117/12.2237850}\n");
        assertThat(copied.chars().filter(letter -> letter == '{').count())
                .isEqualTo(copied.chars().filter(letter -> letter == '}').count());
    }

    /** A place in the picture means nothing in that of another scene. */
    @Test
    void whatIsPinnedStaysPinnedInItsSceneAlone() {
        driver.completePicture();
        driver.click(driver.centre(driver.find(PictureCanvas.class, "picture")));
        JTextPane story = driver.find(JTextPane.class, "ray.story");
        await("the pinned ray", story::isShowing);
        Studio before = driver.studio();
        Studio moving = before.withVelocity(Velocity.of(0, 0, 0.5));
        driver.set(moving);
        driver.completePicture();
        assertThat(story.isShowing()).isTrue();
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio()).isEqualTo(before);
        driver.menu("menu.new");
        await("the new scene", () -> driver.studio().scene().isEmpty());
        assertThat(story.isShowing()).isFalse();
    }

    @Test
    void aPinThatLiesBesideASmallerPictureIsGone() {
        driver.completePicture();
        driver.click(driver.centre(driver.find(PictureCanvas.class, "picture")));
        JTextPane story = driver.find(JTextPane.class, "ray.story");
        await("the pinned ray", () -> story.isShowing() && story.getText().contains("Pixel 160, 120"));

        size(161, 121);
        assertThat(story.isShowing()).isTrue();
        size(160, 120);
        assertThat(story.isShowing()).isFalse();
    }

    private void size(int width, int height) {
        StudioModel model = driver.window().model();
        onEventThread(() ->
                model.set(model.studio().withSettings(model.studio().settings().withSize(width, height))));
        driver.completePicture();
    }

    @Test
    void thePictureIsSplitByADividerThatCanBeDragged() {
        driver.enlarge();
        JComboBox<?> other = driver.find(JComboBox.class, "Compare with");
        onEventThread(() -> other.setSelectedItem(ComparePanel.Other.AT_REST));
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        await(
                "the other picture",
                () -> canvas.shown().other() != null && canvas.shown().other().complete());
        assertThat(canvas.shown().other().plan().isAtRest()).isTrue();
        Rectangle bounds = onEventThread(canvas::pictureBounds);
        Point corner = onEventThread(canvas::getLocationOnScreen);
        Point divider = new Point(corner.x + bounds.x + bounds.width / 2, corner.y + bounds.y + bounds.height / 2);
        driver.drag(divider, new Point(divider.x - bounds.width / 4, divider.y), 10);
        double dragged = canvas.divider();
        assertThat(dragged).isCloseTo(0.25, within(0.02));
        driver.key(KeyEvent.VK_RIGHT, KeyEvent.VK_CONTROL);
        driver.key(KeyEvent.VK_RIGHT, KeyEvent.VK_CONTROL);
        assertThat(canvas.divider()).isCloseTo(dragged + 0.04, within(1e-12));
        driver.key(KeyEvent.VK_LEFT, KeyEvent.VK_CONTROL);
        assertThat(canvas.divider()).isCloseTo(dragged + 0.02, within(1e-12));
        driver.move(new Point(corner.x + bounds.x + bounds.width / 8, divider.y));
        await("the moving camera's reading", () -> driver.said().contains("to the velocity"));
        driver.move(new Point(corner.x + bounds.x + bounds.width * 5 / 8, divider.y));
        await(
                "the reading of the camera at rest, which has no angle to the velocity",
                () -> driver.said().startsWith("Pixel 200, ") && !driver.said().contains("to the velocity"));
        driver.click(new Point(corner.x + bounds.x + bounds.width * 5 / 8, divider.y));
        await(
                "the pinned ray of that picture",
                () -> driver.find(JTextPane.class, "ray.story")
                        .getText()
                        .matches("(?s)Pixel 200, [0-9]+ in the picture \u201cThe camera at rest\u201d\n.*"));
        Point atLeft = new Point(bounds.x + bounds.width / 8, bounds.y + bounds.height / 2);
        assertThat(onEventThread(() -> canvas.shownAt(atLeft)))
                .isSameAs(canvas.shown().now());
        driver.hold(KeyEvent.VK_F8);
        await(
                "the other picture alone",
                () -> canvas.shownAt(atLeft) == canvas.shown().other());
        // the key may be let go of in another window
        driver.menu("menu.about");
        await("both pictures", () -> canvas.shownAt(atLeft) == canvas.shown().now());
        driver.release(KeyEvent.VK_F8);
        driver.key(KeyEvent.VK_ESCAPE);
        JComboBox<?> both = driver.find(JComboBox.class, "Both pictures");
        onEventThread(() -> both.setSelectedItem(Comparison.DIFFERENCE));
        await("the difference", () -> canvas.shown().difference() != null);
    }

    @Test
    @Thorough
    void thePictureGoesToTheClipboard() throws Exception {
        Picture picture = driver.completePicture();
        driver.key(KeyEvent.VK_C, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
        await("the picture", () -> driver.said().equals("The picture is on the clipboard."));
        BufferedImage copy =
                (BufferedImage) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.imageFlavor);
        assertThat(copy.getWidth()).isEqualTo(320);
        assertThat(copy.getRGB(160, 120)).isEqualTo(picture.levels().getRGB(160, 120));
    }

    @Test
    void aSlowPictureIsStoppedAndGoesOn() {
        showSlowPicture();
        RenderController controller = driver.window().view().controller();
        JLabel picture = driver.find(JLabel.class, "status.picture");
        List<String> saidAfterTheStop = new CopyOnWriteArrayList<>();
        picture.addPropertyChangeListener("text", change -> {
            if (controller.isStopped()) {
                saidAfterTheStop.add(picture.getText());
            }
        });
        driver.click(driver.find(PictureCanvas.class, "picture"));
        driver.key(KeyEvent.VK_ESCAPE);
        assertThat(controller.isStopped()).as("by a key that closes things").isFalse();
        driver.menu("menu.stop");
        await("the end of the work", () -> controller.isStopped() && !controller.isBusy());
        assertThat(driver.picture().complete()).isFalse();
        await("the word for it", () -> picture.getText().contains(", stopped"));
        assertThat(saidAfterTheStop).allMatch(text -> text.contains(", stopped"));
        driver.menu("menu.stop");
        await("work", controller::isBusy);
    }

    /** Escape takes back one thing at a time. */
    @Test
    void escapeWhilePlayingPausesAndThePictureIsCompleted() {
        driver.completePicture();
        driver.menu("menu.playSpeed");
        Studio before = driver.studio();
        await("another speed", () -> !driver.studio().equals(before));
        driver.key(KeyEvent.VK_ESCAPE);
        Studio paused = driver.completePicture().studio();
        assertThat(driver.studio()).isEqualTo(paused);
    }

    /** Tab, too, brings the focus without a click. */
    @Test
    void typingIntoAFocusedFieldReplacesItsValue() {
        JTextField opens = driver.find(JTextField.class, "Opening time");
        onEventThread(() -> opens.requestFocusInWindow());
        await("the focus", opens::isFocusOwner);
        driver.key(KeyEvent.VK_5);
        driver.key(KeyEvent.VK_ENTER);
        assertThat(driver.studio().camera().shutter().openingTime()).isEqualTo(5);
    }

    @Test
    void closingEndsTheThreadsOfASlowPicture() {
        showSlowPicture();
        driver.close();
        driver = null;
        Waiting.until("the end of all threads", () -> ownThreads().findAny().isEmpty());
    }

    private void showSlowPicture() {
        driver.set(Studios.slow());
        await("the slow picture", () -> driver.picture().studio().equals(Studios.slow()));
    }

    private static Stream<Thread> ownThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(Thread::isAlive)
                .filter(thread -> thread.getName().startsWith("tompkins-"));
    }
}
