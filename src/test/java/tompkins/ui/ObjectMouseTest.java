package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.io.StudioWriter;
import tompkins.light.AmbientLight;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.surface.ColouredSurface;
import tompkins.ui.picture.PictureCanvas;

/** Objects that are dragged in the picture with the mouse. */
@Timeout(300)
@NeedsDisplay
class ObjectMouseTest {

    private static final Sphere BALL = new Sphere("ball", new Vector3d(0, 0, 10), 1, ColouredSurface.DEFAULT);

    /** Its front is 9 before the lens, where the right ball's is 8. */
    private static final Placed RIGHT = new Placed(
            "right",
            new Sphere("inner", new Vector3d(), 0.5, ColouredSurface.DEFAULT),
            2,
            new Vector3d(0, 1, 0),
            0,
            new Vector3d(1.5, 0, 9));

    @TempDir
    private Path folder;

    @AutoClose
    private WindowDriver driver;

    private PictureCanvas canvas;
    private Studio opened;

    /** What a pixel of the screen is wide at a depth of 1. */
    private double pixel;

    @BeforeEach
    void open() {
        Studio studio = Studio.DEFAULT
                .withScene(List.of(BALL, RIGHT))
                .withSettings(Studio.DEFAULT.settings().withSize(320, 240));
        driver = new WindowDriver(folder.resolve("settings"), studio, null, List.of());
        opened = driver.studio();
        canvas = driver.find(PictureCanvas.class, "picture");
        double half = Math.tan(Math.toRadians(opened.camera().horizontalAngleDegrees() / 2));
        pixel = WindowDriver.onEventThread(() -> 2 * half / canvas.pictureBounds().width);
    }

    private void edit(String part) {
        WindowDriver.onEventThread(
                () -> driver.window().side().edit(StudioPath.parse(part).orElseThrow()));
        WindowDriver.await("the editor", () -> editors().findAny().isPresent());
        WindowDriver.onEventThread(() -> {
            // beside each other
            driver.window().frame().setLocation(760, 100);
            editors().forEach(editor -> editor.setLocation(0, 0));
        });
        // a window manager takes its time, and puts a border around them
        WindowDriver.await(
                "the places of the windows",
                () -> driver.window().frame().getLocationOnScreen().distance(760, 100) < 60
                        && editors()
                                .allMatch(editor -> editor.getLocationOnScreen().distance(0, 0) < 60));
        driver.completePicture();
    }

    private Stream<JDialog> editors() {
        return Components.showing(driver.window().frame(), JDialog.class)
                .filter(dialog -> "editor".equals(dialog.getName()));
    }

    /** A point of the screen, so far from the middle of the picture. */
    private Point at(double right, double down) {
        return WindowDriver.onEventThread(() -> {
            Rectangle bounds = canvas.pictureBounds();
            Point corner = canvas.getLocationOnScreen();
            return new Point(
                    (int) (corner.x + bounds.getCenterX() + right), (int) (corner.y + bounds.getCenterY() + down));
        });
    }

    /** The studio as it is now, for the event thread and for others. */
    private Studio now() {
        return SwingUtilities.isEventDispatchThread() ? driver.window().model().studio() : driver.studio();
    }

    private Vector3dc centre() {
        return ((Sphere) now().scene().get(0)).centre();
    }

    private Vector3dc place() {
        return ((Placed) now().scene().get(1)).translation();
    }

    private byte[] file() throws IOException {
        Path file = folder.resolve("scene.json");
        StudioWriter.save(driver.studio(), file, true);
        return Files.readAllBytes(file);
    }

    private String chosen() {
        JTree tree = Components.find(driver.window().frame(), JTree.class, "tree");
        return String.valueOf(tree.getSelectionPath().getLastPathComponent());
    }

    @Test
    void theBallFollowsTheMouseInOneStep() throws IOException {
        edit("scene[1]");
        byte[] before = file();
        driver.beginDrag(at(0, 0), at(90, -45), 12);
        WindowDriver.await("the ball", () -> centre().x() > 85 * 9 * pixel);
        assertThat(chosen()).isEqualTo("ball");
        driver.endDrag();
        WindowDriver.await("the end of the way", () -> Math.abs(centre().x() / (9 * pixel) - 90) < 0.6);
        assertThat(centre().y()).isCloseTo(45 * 9 * pixel, within(0.6 * 9 * pixel));
        assertThat(centre().z()).isCloseTo(10, within(0.005));
        assertThat(place()).isEqualTo(RIGHT.translation());
        assertThat(driver.studio().camera()).isEqualTo(opened.camera());
        JTextField field = field();
        assertThat(Double.parseDouble(field.getText())).isCloseTo(centre().x(), within(1e-4));
        assertThat(WindowDriver.onEventThread(() -> driver.window().model().isEdited()))
                .isTrue();
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(file()).isEqualTo(before);
        assertThat(WindowDriver.onEventThread(() -> driver.window().model().canUndo()))
                .isFalse();
        driver.key(KeyEvent.VK_Y, KeyEvent.VK_CONTROL);
        assertThat(centre().x()).isCloseTo(90 * 9 * pixel, within(0.6 * 9 * pixel));
    }

    /** A lamp is marked where its light comes from, 5 before the lens; it is chosen there, and moves like an object. */
    @Test
    void aLampIsChosenAndDragged() {
        Vector3d place = new Vector3d(-100 * 5 * pixel, 0, 5);
        PointLight lamp = new PointLight(place, Colour.WHITE, Colour.WHITE, 40);
        WindowDriver.onEventThread(() ->
                driver.window().model().set(Descriptions.with(opened, "lights", List.of(AmbientLight.DEFAULT, lamp))));
        driver.completePicture();
        assertThat(WindowDriver.<Boolean>onEventThread(this::isMarked))
                .as("while the editor is closed")
                .isFalse();
        edit("scene[0]");
        WindowDriver.await("the mark", this::isMarked);
        driver.click(at(-98, 2));
        WindowDriver.await("the choice", () -> chosen().startsWith("Point light"));
        driver.drag(at(-100, 0), at(-70, 30), 6);
        WindowDriver.await(
                "the lamp",
                () -> Math.abs(lampAt().x() / lampAt().z() / pixel + 70) < 0.6
                        && Math.abs(lampAt().y() / lampAt().z() / pixel + 30) < 0.6);
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        assertThat(lampAt()).isEqualTo(place);
    }

    private Vector3dc lampAt() {
        return ((PointLight) now().lights().get(1)).position();
    }

    /** For the event thread. */
    private boolean isMarked() {
        BufferedImage image = new BufferedImage(canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
        canvas.paint(image.createGraphics());
        return IntStream.of(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .anyMatch(colour -> (colour & 0xffffff) == 0xffe060);
    }

    /** The first number of the form's vector. */
    private JTextField field() {
        return WindowDriver.onEventThread(
                () -> Components.showing(driver.window().frame(), JDialog.class)
                        .flatMap(Components::all)
                        .filter(JTextField.class::isInstance)
                        .map(JTextField.class::cast)
                        .filter(each -> String.valueOf(each.getName()).startsWith("Centre"))
                        .findFirst()
                        .orElseThrow());
    }

    /** What is chosen moves with all that it holds; what is in it moves alone, in coordinates of its own. */
    @Test
    void theChosenPartMoves() {
        edit("scene[1]");
        int right = (int) Math.round(1.5 / (8 * pixel)) - 20;
        driver.drag(at(right, 0), at(right, 60), 8);
        WindowDriver.await("the place", () -> place().y() < -0.1);
        WindowDriver.await("the end of the way", () -> !isBusy(60, place().y() / depth()));
        assertThat(((Placed) driver.studio().scene().get(1)).object()).isEqualTo(RIGHT.object());
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
        WindowDriver.onEventThread(
                () -> driver.window().side().edit(StudioPath.parse("scene[0]").orElseThrow()));
        driver.completePicture();
        driver.drag(at(right, 0), at(right, 60), 8);
        WindowDriver.await("the inner ball", () -> inner().y() < -0.1);
        WindowDriver.await("the end of the way", () -> !isBusy(60, 2 * inner().y() / depth()));
        assertThat(place()).isEqualTo(RIGHT.translation());
        assertThat(chosen()).isEqualTo("Object: inner");
    }

    private Vector3dc inner() {
        return ((Sphere) ((Placed) now().scene().get(1)).object()).centre();
    }

    /** Where the ball is met, 20 pixels beside its middle. */
    private double depth() {
        double x = (Math.round(1.5 / (8 * pixel)) - 19.5) * pixel;
        // (s x - 1.5)^2 + (s - 9)^2 = 1
        double a = x * x + 1;
        double b = 1.5 * x + 9;
        return (b - Math.sqrt(b * b - a * (1.5 * 1.5 + 80))) / a;
    }

    private boolean isBusy(int pixels, double slope) {
        return Math.abs(-slope / pixel - pixels) > 0.6;
    }

    @Test
    void escapeGivesTheBallBack() throws IOException {
        edit("scene[0]");
        byte[] before = file();
        driver.beginDrag(at(0, 0), at(-70, 10), 8);
        WindowDriver.await("the ball", () -> centre().x() < -0.1);
        driver.key(KeyEvent.VK_ESCAPE);
        assertThat(file()).isEqualTo(before);
        driver.endDrag();
        driver.completePicture();
        assertThat(driver.studio()).isEqualTo(opened);
        assertThat(WindowDriver.onEventThread(() -> driver.window().model().canUndo()))
                .isFalse();
        assertThat(editors()).as("the editor stays").hasSize(1);
    }

    /** Once, and politely. */
    @Test
    void theSkyTurnsTheCamera() {
        edit("scene[0]");
        assertThat(isSomethingSaid()).isFalse();
        double left = 10 - WindowDriver.onEventThread(() -> canvas.pictureBounds().width / 2.0);
        driver.beginDrag(at(left, 0), at(left + 10, 0), 2);
        WindowDriver.await("the refusal", () -> !canvas.hand().isTaken());
        driver.move(at(left + 40, 0));
        driver.endDrag();
        WindowDriver.await("the turn", () -> !now().camera().equals(opened.camera()));
        assertThat(driver.studio().scene()).isEqualTo(opened.scene());
        assertThat(isSomethingSaid()).isTrue();
    }

    /** Whether a light text on a dark ground stands at the top of the picture, in the middle. */
    private boolean isSomethingSaid() {
        return WindowDriver.onEventThread(() -> {
            Rectangle bounds = canvas.pictureBounds();
            BufferedImage image = new BufferedImage(canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
            canvas.paint(image.getGraphics());
            int row = bounds.y + 20;
            return IntStream.range(bounds.x + bounds.width / 4, bounds.x + 3 * bounds.width / 4)
                    .map(column -> image.getRGB(column, row) & 0xff)
                    .boxed()
                    .collect(Collectors.teeing(
                            Collectors.filtering(level -> level < 110, Collectors.counting()),
                            Collectors.filtering(level -> level > 240, Collectors.counting()),
                            (dark, light) -> dark > 50 && light > 5));
        });
    }

    @Test
    void aPressWithoutAWayIsAClick() {
        edit("scene[1]");
        driver.drag(at(0, 0), at(2, 1), 2);
        WindowDriver.await("the choice", () -> chosen().equals("ball"));
        assertThat(driver.studio()).isEqualTo(opened);
    }

    @Test
    void withoutTheEditorADragTurnsTheCamera() {
        driver.completePicture();
        driver.drag(at(0, 0), at(60, 0), 8);
        assertThat(driver.studio().scene()).isEqualTo(opened.scene());
        assertThat(driver.studio().camera()).isNotEqualTo(opened.camera());
    }
}
