package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JSlider;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTextPane;
import javax.swing.JTree;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.TestRun;
import tompkins.Thorough;
import tompkins.Waiting;
import tompkins.image.PhotographFile;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.render.Renderer;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.trace.RenderPlan;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.RenderController;

/** The real window, used with mouse and keys. */
@Timeout(600)
@NeedsDisplay
class WindowTest {

    private static final Path SCENES = Path.of(System.getProperty("basedir", ""), "scenes");

    @TempDir
    private Path folder;

    private static List<Studio> examples;

    @AutoClose
    private WindowDriver driver;

    @BeforeAll
    static void readExamples() throws IOException {
        examples = readScenes();
    }

    @BeforeEach
    void open() throws IOException {
        Path file = folder.resolve("lattice.json");
        Studio studio = Studios.lattice().withSettings(Studio.DEFAULT.settings().withSize(320, 240));
        StudioWriter.save(studio, file, true);
        driver = new WindowDriver(folder, studio, file, examples);
    }

    /** The scenes of the project, small, so that they are quick. */
    private static List<Studio> readScenes() throws IOException {
        try (Stream<Path> files = Files.list(SCENES)) {
            return files.filter(file -> file.toString().endsWith(".json"))
                    .sorted()
                    .map(StudioReader::read)
                    .map(studio -> studio.withSettings(
                            studio.settings().withSize(48, 36).withSamples(1)))
                    .toList();
        }
    }

    @Test
    void startsWithThePictureOfTheScene() throws InterruptedException {
        Picture picture = driver.completePicture();
        try (Renderer renderer = new Renderer(1)) {
            float[] expected = renderer.render(RenderPlan.of(driver.studioOnScreen()))
                    .image()
                    .rgb();
            assertThat(picture.image().rgb()).isEqualTo(expected);
        }
        assertThat(driver.window().frame().getTitle()).isEqualTo("Untitled \u2013 lattice.json \u2013 Tompkins");
    }

    @Test
    void draggingTheSpeedSliderChangesTheSpeedInOneStep() {
        JSlider slider = driver.find(JSlider.class, "Speed, slider");
        Velocity before = driver.studio().velocity();
        Point middle = driver.centre(slider);
        int left = WindowDriver.onEventThread(() -> slider.getLocationOnScreen().x);
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
    void thePanelSaysWhatThereIsToSee() {
        JTextArea remarks = driver.find(JTextArea.class, "remarks");
        assertThat(remarks.isVisible()).isFalse();
        Studio cube = StudioReader.read(SCENES.resolve("terrell-cube.json"));
        WindowDriver.onEventThread(() -> driver.window().model().set(cube));
        assertThat(remarks.isShowing()).isTrue();
        assertThat(remarks.getText()).startsWith("A cube that a fast camera passes does not look shortened but turned");
    }

    @Test
    void aTypedTimeIsTaken() {
        driver.type(driver.find(JTextField.class, "Opening time"), "-2.5");
        assertThat(driver.studio().camera().shutter().openingTime()).isEqualTo(-2.5);
        assertThat(driver.completePicture().studio()).isEqualTo(driver.studio());
    }

    @Test
    void whatIsTypedStaysWhileSomethingPlays() {
        driver.menu("menu.playSpeed");
        JTextField opens = driver.find(JTextField.class, "Opening time");
        driver.typeWithoutEnter(opens, "-2");
        Studio before = driver.studio();
        WindowDriver.await(
                "another speed", () -> !driver.window().model().studio().equals(before));
        assertThat(opens.getText()).isEqualTo("-2");
        driver.key(KeyEvent.VK_ENTER);
        assertThat(driver.studio().camera().shutter().openingTime()).isEqualTo(-2);
    }

    @Test
    void aWrongValueIsMarkedAndTheLastPictureStays() {
        Picture before = driver.completePicture();
        JTextField speed = driver.find(JTextField.class, "Speed");
        driver.type(speed, "1.2");
        assertThat(Components.isMarked(speed)).isTrue();
        assertThat(driver.picture()).isSameAs(before);
        driver.type(speed, "0.5");
        assertThat(Components.isMarked(speed)).isFalse();
        assertThat(driver.studio().velocity().speed()).isEqualTo(0.5);
    }

    @Test
    void everyShutterCanBeChosen() {
        JComboBox<?> models = driver.find(JComboBox.class, "Shutter");
        driver.click(models);
        driver.key(KeyEvent.VK_HOME);
        driver.key(KeyEvent.VK_ENTER);
        for (int i = 0; i < models.getItemCount(); i++) {
            Class<?> model = (Class<?>) models.getItemAt(i);
            int index = i;
            WindowDriver.onEventThread(() -> models.setSelectedIndex(index));
            assertThat(driver.studio().camera().shutter()).isInstanceOf(model);
            driver.completePicture();
        }
    }

    @Test
    void everyExampleOpens() {
        WindowDriver.await(
                "the examples",
                () -> Components.all(driver.window().frame())
                        .anyMatch(item -> examples.get(0).title().equals(item.getName())));
        for (int i = 0; i < examples.size(); i += TestRun.cases(8, 1)) {
            Studio example = examples.get(i);
            driver.menu(example.title());
            WindowDriver.await(
                    example.title(), () -> driver.window().model().studio().equals(example));
            driver.completePicture();
        }
    }

    @Test
    void theMouseReadsPixelsAndAClickPinsOne() {
        driver.completePicture();
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        Point middle = driver.centre(canvas);
        driver.move(middle);
        JLabel what = driver.find(JLabel.class, "status.what");
        WindowDriver.await("the reading", () -> what.getText().startsWith("Pixel 160, 120"));
        assertThat(what.getText()).contains("to the velocity");
        assertThat(driver.find(JLabel.class, "status.where").getText()).contains("Doppler factor");
        driver.click(middle);
        WindowDriver.await(
                "the pinned ray",
                () -> Components.find(driver.window().frame(), JTextPane.class, "ray.story")
                        .getText()
                        .contains("Pixel 160, 120"));
    }

    @Test
    void theObjectThatAPinnedRayHitIsEdited() {
        WindowDriver.onEventThread(() -> driver.window().model().set(Studios.sphere()));
        driver.completePicture();
        driver.click(driver.centre(driver.find(PictureCanvas.class, "picture")));
        JButton edit = driver.find(JButton.class, "Edit");
        WindowDriver.await("the pinned ray", () -> edit.isShowing() && edit.isEnabled());
        WindowDriver.onEventThread(() -> edit.doClick());
        JTree tree = driver.find(JTree.class, "tree");
        assertThat(WindowDriver.onEventThread(() -> tree.getSelectionPath().toString()))
                .endsWith("Scene, sphere]");
        Studio empty = driver.studio().withScene(List.of());
        WindowDriver.onEventThread(() -> driver.window().model().set(empty));
        WindowDriver.await("a ray that hits nothing", () -> !edit.isEnabled());
    }

    @Test
    @Thorough
    void theCitationIsCopied() throws Exception {
        JLabel what = driver.find(JLabel.class, "status.what");
        driver.menu("menu.cite");
        driver.answer("Copy BibTeX");
        WindowDriver.await("the answer", () -> what.getText().equals("The citation is on the clipboard."));
        String copied =
                (String) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
        assertThat(copied)
                .startsWith("@software{tompkins,\n")
                .endsWith("}\n")
                .contains("  version = {" + SelfDescription.version() + "},\n", "  doi = {10.1117/12.2237850}\n");
        assertThat(copied.chars().filter(letter -> letter == '{').count())
                .isEqualTo(copied.chars().filter(letter -> letter == '}').count());
    }

    @Test
    void theKeysReadPixelsAndPinOne() {
        driver.completePicture();
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        JLabel what = driver.find(JLabel.class, "status.what");
        WindowDriver.onEventThread(() -> canvas.requestFocusInWindow());
        WindowDriver.await("the focus", canvas::isFocusOwner);
        driver.key(KeyEvent.VK_RIGHT);
        WindowDriver.await("the pixel beside the middle", () -> what.getText().startsWith("Pixel 161, 120"));
        driver.key(KeyEvent.VK_RIGHT, KeyEvent.VK_SHIFT);
        driver.key(KeyEvent.VK_UP);
        WindowDriver.await("the pixel up and to the right", () -> what.getText().startsWith("Pixel 171, 119"));
        driver.key(KeyEvent.VK_ENTER);
        WindowDriver.await(
                "the pinned ray",
                () -> Components.find(driver.window().frame(), JTextPane.class, "ray.story")
                        .getText()
                        .contains("Pixel 171, 119"));
    }

    /** A place in the picture means nothing in that of another scene. */
    @Test
    void whatIsPinnedStaysPinnedInItsSceneAlone() {
        driver.completePicture();
        driver.click(driver.centre(driver.find(PictureCanvas.class, "picture")));
        JTextPane story = driver.find(JTextPane.class, "ray.story");
        WindowDriver.await("the pinned ray", story::isShowing);
        Studio before = driver.studio();
        Studio moving = before.withVelocity(Velocity.of(0, 0, 0.5));
        WindowDriver.onEventThread(() -> driver.window().model().set(moving));
        driver.completePicture();
        assertThat(story.isShowing()).isTrue();
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio()).isEqualTo(before);
        driver.menu("menu.new");
        WindowDriver.await(
                "the new scene", () -> driver.window().model().studio().scene().isEmpty());
        assertThat(story.isShowing()).isFalse();
    }

    @Test
    void aPinThatLiesBesideASmallerPictureIsGone() {
        driver.completePicture();
        driver.click(driver.centre(driver.find(PictureCanvas.class, "picture")));
        JTextPane story = driver.find(JTextPane.class, "ray.story");
        WindowDriver.await(
                "the pinned ray", () -> story.isShowing() && story.getText().contains("Pixel 160, 120"));

        size(161, 121);
        assertThat(story.isShowing()).isTrue();
        size(160, 120);
        assertThat(story.isShowing()).isFalse();
    }

    private void size(int width, int height) {
        StudioModel model = driver.window().model();
        WindowDriver.onEventThread(() ->
                model.set(model.studio().withSettings(model.studio().settings().withSize(width, height))));
        driver.completePicture();
    }

    @Test
    void escapeClosesAMenu() {
        WindowDriver.later(driver.find(JMenu.class, "menu.file")::doClick);
        MenuSelectionManager menus = MenuSelectionManager.defaultManager();
        WindowDriver.await("the menu", () -> menus.getSelectedPath().length > 0);
        driver.key(KeyEvent.VK_ESCAPE);
        assertThat(WindowDriver.onEventThread(menus::getSelectedPath)).isEmpty();
    }

    @Test
    void theMenuWritesACaptionIntoThePictureAndTakesItAway() {
        driver.completePicture();
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        int[] plain = WindowDriver.onEventThread(() -> painted(canvas));
        driver.menu("menu.caption");
        WindowDriver.await("the caption", () -> !Arrays.equals(plain, painted(canvas)));
        driver.key(KeyEvent.VK_F7);
        WindowDriver.await("the picture without it", () -> Arrays.equals(plain, painted(canvas)));
    }

    private static int[] painted(PictureCanvas canvas) {
        BufferedImage image = new BufferedImage(canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
        canvas.paint(image.createGraphics());
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void thePictureIsSplitByADividerThatCanBeDragged() {
        driver.enlarge();
        driver.completePicture();
        JComboBox<?> other = driver.find(JComboBox.class, "Compare with");
        WindowDriver.onEventThread(() -> other.setSelectedItem(ComparePanel.Other.AT_REST));
        PictureCanvas canvas = driver.find(PictureCanvas.class, "picture");
        WindowDriver.await(
                "the other picture",
                () -> canvas.shown().other() != null && canvas.shown().other().complete());
        assertThat(canvas.shown().other().plan().isAtRest()).isTrue();
        Rectangle bounds = WindowDriver.onEventThread(canvas::pictureBounds);
        Point corner = WindowDriver.onEventThread(canvas::getLocationOnScreen);
        Point divider = new Point(corner.x + bounds.x + bounds.width / 2, corner.y + bounds.y + bounds.height / 2);
        driver.drag(divider, new Point(divider.x - bounds.width / 4, divider.y), 10);
        double dragged = canvas.divider();
        assertThat(dragged).isCloseTo(0.25, within(0.02));
        driver.key(KeyEvent.VK_RIGHT, KeyEvent.VK_CONTROL);
        driver.key(KeyEvent.VK_RIGHT, KeyEvent.VK_CONTROL);
        assertThat(canvas.divider()).isCloseTo(dragged + 0.04, within(1e-12));
        driver.key(KeyEvent.VK_LEFT, KeyEvent.VK_CONTROL);
        assertThat(canvas.divider()).isCloseTo(dragged + 0.02, within(1e-12));
        JLabel what = driver.find(JLabel.class, "status.what");
        driver.move(new Point(corner.x + bounds.x + bounds.width / 8, divider.y));
        WindowDriver.await("the moving camera's reading", () -> what.getText().contains("to the velocity"));
        driver.move(new Point(corner.x + bounds.x + bounds.width * 5 / 8, divider.y));
        WindowDriver.await(
                "the reading of the camera at rest, which has no angle to the velocity",
                () -> what.getText().startsWith("Pixel 200, ")
                        && !what.getText().contains("to the velocity"));
        driver.click(new Point(corner.x + bounds.x + bounds.width * 5 / 8, divider.y));
        WindowDriver.await(
                "the pinned ray of that picture",
                () -> Components.find(driver.window().frame(), JTextPane.class, "ray.story")
                        .getText()
                        .matches("(?s)Pixel 200, [0-9]+ in the picture \u201cThe camera at rest\u201d\n.*"));
        Point atLeft = new Point(bounds.x + bounds.width / 8, bounds.y + bounds.height / 2);
        assertThat(WindowDriver.onEventThread(() -> canvas.shownAt(atLeft)))
                .isSameAs(canvas.shown().now());
        driver.hold(KeyEvent.VK_F8);
        WindowDriver.await(
                "the other picture alone",
                () -> canvas.shownAt(atLeft) == canvas.shown().other());
        // the key may be let go of in another window
        driver.menu("menu.about");
        WindowDriver.await(
                "both pictures", () -> canvas.shownAt(atLeft) == canvas.shown().now());
        driver.release(KeyEvent.VK_F8);
        driver.key(KeyEvent.VK_ESCAPE);
        JComboBox<?> both = driver.find(JComboBox.class, "Both pictures");
        WindowDriver.onEventThread(() -> both.setSelectedItem(Comparison.DIFFERENCE));
        WindowDriver.await("the difference", () -> canvas.shown().difference() != null);
    }

    @Test
    void whatWasSavedOpensAndGivesTheSameBytes() throws InterruptedException {
        driver.type(driver.find(JTextField.class, "Speed"), "0.9");
        Studio before = driver.studio();
        driver.key(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
        WindowDriver.await("the saved file", () -> !driver.window().model().isModified());
        Studio read = StudioReader.read(folder.resolve("lattice.json"));
        assertThat(read).isEqualTo(driver.studio());
        try (Renderer renderer = new Renderer(2)) {
            assertThat(renderer.render(RenderPlan.of(read)).image().rgb())
                    .isEqualTo(renderer.render(RenderPlan.of(before)).image().rgb());
        }
    }

    @Test
    void thePhotographIsSavedWithItsScene() throws IOException {
        driver.completePicture();
        driver.key(KeyEvent.VK_E, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
        Path file = folder.resolve("photograph.png");
        driver.choose(file);
        JLabel what = driver.find(JLabel.class, "status.what");
        WindowDriver.await("the photograph", () -> what.getText().startsWith("Saved"));
        String scene = PhotographFile.readScene(file).orElseThrow();
        assertThat(StudioReader.read(scene, "photograph", folder)).isEqualTo(driver.studio());
        assertThat(new File(file.toString())).isNotEmpty();
    }

    @Test
    @Thorough
    void thePictureGoesToTheClipboard() throws Exception {
        Picture picture = driver.completePicture();
        driver.key(KeyEvent.VK_C, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
        JLabel what = driver.find(JLabel.class, "status.what");
        WindowDriver.await("the picture", () -> what.getText().equals("The picture is on the clipboard."));
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
        WindowDriver.await("the end of the work", () -> controller.isStopped() && !controller.isBusy());
        assertThat(driver.picture().complete()).isFalse();
        WindowDriver.await("the word for it", () -> picture.getText().contains(", stopped"));
        assertThat(saidAfterTheStop).allMatch(text -> text.contains(", stopped"));
        driver.menu("menu.stop");
        WindowDriver.await("work", controller::isBusy);
    }

    /** Escape takes back one thing at a time. */
    @Test
    void escapeWhilePlayingPausesAndThePictureIsCompleted() {
        driver.completePicture();
        driver.menu("menu.playSpeed");
        Studio before = driver.studio();
        WindowDriver.await(
                "another speed", () -> !driver.window().model().studio().equals(before));
        driver.key(KeyEvent.VK_ESCAPE);
        Studio paused = driver.completePicture().studio();
        assertThat(driver.studio()).isEqualTo(paused);
    }

    @Test
    void theReadingFollowsThePictureWhileTheMouseRests() {
        driver.completePicture();
        driver.move(driver.centre(driver.find(PictureCanvas.class, "picture")));
        JLabel what = driver.find(JLabel.class, "status.what");
        WindowDriver.await("the reading", () -> what.getText().contains("to the velocity"));
        WindowDriver.onEventThread(() ->
                driver.window().model().set(driver.window().model().studio().withVelocity(Velocity.REST)));
        WindowDriver.await(
                "the reading at rest",
                () -> what.getText().startsWith("Pixel ") && !what.getText().contains("to the velocity"));
    }

    /** Tab, too, brings the focus without a click. */
    @Test
    void typingIntoAFocusedFieldReplacesItsValue() {
        JTextField opens = driver.find(JTextField.class, "Opening time");
        WindowDriver.onEventThread(() -> opens.requestFocusInWindow());
        WindowDriver.await("the focus", opens::isFocusOwner);
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
        WindowDriver.onEventThread(() -> driver.window().model().set(Studios.slow()));
        WindowDriver.await("the slow picture", () -> driver.picture().studio().equals(Studios.slow()));
    }

    private static Stream<Thread> ownThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(Thread::isAlive)
                .filter(thread -> thread.getName().startsWith("tompkins-"));
    }

    @Test
    void playRunsTheSpeed() {
        driver.completePicture();
        driver.menu("menu.playSpeed");
        double before = driver.studio().velocity().speed();
        WindowDriver.await(
                "another speed",
                () -> Math.abs(driver.window().model().studio().velocity().speed() - before) > 0.05);
        driver.key(KeyEvent.VK_F9);
        Studio paused = driver.studio();
        driver.completePicture();
        assertThat(driver.studio()).isEqualTo(paused);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(driver.studio().velocity().speed()).as("one step").isCloseTo(before, within(1e-12));
    }
}
