package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButton;
import javax.swing.JSlider;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTextPane;
import org.joml.Vector2dc;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.image.Palette;
import tompkins.io.BundledScenes;
import tompkins.io.StudioReader;
import tompkins.measure.MeasureKind;
import tompkins.measure.OverlayKind;
import tompkins.measure.Overlays;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.ride.RidePilot;
import tompkins.ui.widget.Texts;

/**
 * The pictures of the window in {@code docs/pictures}: with {@code -Dtompkins.regenerate=true}, or the name of one, and
 * a display they are taken again; without, they must be there and small.
 */
@Timeout(300)
class WindowPicturesTest {

    private static final Path BASE = Path.of(System.getProperty("basedir", ""));
    /** On board, between the halt before the tower and the flight through its gate. */
    private static final double RIDE_TIME = 5;

    private static final long LARGEST = 125_000;

    /** The pictures. */
    enum Shot {
        DEFAULT("town-square"),
        CONTROLS("terrell-cube"),
        PROJECTOR("town-square"),
        RIDE("town-square"),
        PINNED_RAY("terrell-cube"),
        MEASURING("penrose-sphere"),
        ERROR("fig1b"),
        LESSON("lesson-02-turned-cube");

        private final String scene;

        Shot(String scene) {
            this.scene = scene;
        }

        Path file() {
            return BASE.resolve(
                    "docs/pictures/window-" + name().toLowerCase(Locale.ROOT).replace('_', '-') + ".png");
        }
    }

    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnumSource
    void pictureIsThereAndSmall(Shot shot) throws Exception {
        String wanted = System.getProperty("tompkins.regenerate", "");
        if (wanted.equals("true") || wanted.equals(shot.name())) {
            take(shot);
        }
        assertThat(shot.file()).exists();
        assertThat(Files.size(shot.file())).isLessThan(LARGEST);
    }

    private void take(Shot shot) throws Exception {
        Studio studio = StudioReader.read(BASE.resolve("scenes/" + shot.scene + ".json"));
        if (shot == Shot.RIDE) {
            // with more samples the noise, and what is small, have more levels
            studio = studio.withSettings(studio.settings().withSamples(1));
        }
        if (shot == Shot.MEASURING) {
            // the floor would make a large file
            studio = studio.withScene(studio.scene().subList(1, studio.scene().size()));
        }
        FirstScene first = shot == Shot.DEFAULT ? FirstScene.ofProgram(studio, "") : new FirstScene(studio, null);
        try (WindowDriver driver = new WindowDriver(folder, first, BundledScenes.studios())) {
            JMenu examples = driver.find(JMenu.class, "menu.examples");
            JMenu lessons = driver.find(JMenu.class, "menu.lessons");
            WindowDriver.await("the examples and lessons", () -> examples.isEnabled() && lessons.isEnabled());
            arrange(shot, driver);
            driver.completePicture();
            Thread.sleep(500);
            Rectangle bounds =
                    WindowDriver.onEventThread(() -> driver.window().frame().getBounds());
            BufferedImage picture = new Robot().createScreenCapture(bounds);
            write(Palette.reduced(picture), shot.file());
        }
    }

    private static void arrange(Shot shot, WindowDriver driver) {
        switch (shot) {
            case PROJECTOR -> press(driver, JMenuItem.class, "look.PROJECTOR");
            case CONTROLS ->
                WindowDriver.onEventThread(() ->
                        driver.window().side.edit(StudioPath.parse("scene[0]").orElseThrow()));
            case RIDE -> ride(driver);
            case PINNED_RAY -> {
                driver.click(driver.find(PictureCanvas.class, "picture"));
                JTextPane story = driver.find(JTextPane.class, "ray.story");
                WindowDriver.await(
                        "the pinned ray",
                        () -> story.isShowing() && story.getText().contains("Hits cube"));
            }
            case MEASURING -> measure(driver);
            case LESSON -> lead(driver);
            case ERROR -> driver.type(driver.find(JTextField.class, "Speed"), "1.2");
            default -> {}
        }
    }

    /** Overlays, and a circle through four points on the outline of the red ball. */
    private static void measure(WindowDriver driver) {
        for (String overlay : List.of("OUTLINES", "PLACES", "CAMERA_GRID", "HORIZON", "LABELS")) {
            press(driver, JMenuItem.class, "menu.overlay." + overlay);
        }
        press(driver, JMenuItem.class, "menu.measure");
        JComboBox<?> kinds = driver.find(JComboBox.class, "What to measure");
        WindowDriver.onEventThread(() -> kinds.setSelectedItem(MeasureKind.CIRCLE));
        driver.completePicture();
        Projection projection = Projection.of(driver.studioOnScreen());
        Overlays overlays = new Overlays(
                projection,
                SceneShapes.of(driver.picture().plan().world().frames()),
                driver.picture().plan());
        List<Vector2dc> outline = overlays.draw(OverlayKind.OUTLINES).lines().get(0);
        Rectangle bounds =
                WindowDriver.onEventThread(() -> driver.window().view().canvas().pictureBounds());
        Point corner =
                WindowDriver.onEventThread(() -> driver.window().view().canvas().getLocationOnScreen());
        for (int i = 0; i < 4; i++) {
            Vector2dc place = outline.get(i * outline.size() / 4);
            driver.click(new Point(
                    corner.x
                            + bounds.x
                            + (int) (place.x()
                                    * bounds.width
                                    / projection.view().width()),
                    corner.y
                            + bounds.y
                            + (int) (place.y()
                                    * bounds.height
                                    / projection.view().height())));
        }
        JTextArea results = driver.find(JTextArea.class, "measure.results");
        WindowDriver.await("the circle", () -> results.getText().startsWith("half-angle"));
    }

    /** Leads through a lesson to its end. */
    private static void lead(WindowDriver driver) {
        press(driver, JRadioButton.class, "Only the front face, but narrower.");
        press(driver, JRadioButton.class, "I am sure");
        JSlider speed = driver.find(JSlider.class, "Speed of the cube (c), slider");
        for (String step : List.of("LOOK", "REASON", "MEASURE")) {
            WindowDriver.onEventThread(() -> speed.setValue(700));
            press(driver, JButton.class, Texts.get("lesson.next." + step));
        }
        WindowDriver.await(
                "the numbers",
                () -> Components.notes(driver.window().frame()).stream()
                        .anyMatch(text -> text.startsWith("Measured ")));
    }

    /** A moment of the recorded ride, with all that can be drawn over the picture. */
    private static void ride(WindowDriver driver) {
        press(driver, JMenuItem.class, "menu.map.ABOVE");
        press(driver, JMenuItem.class, "menu.replay");
        RidePilot pilot = driver.window().motion.pilot();
        WindowDriver.await("the thrust", () -> pilot.moment().properTime() > RIDE_TIME);
        WindowDriver.onEventThread(() -> pilot.setRiding(false));
    }

    private static void press(WindowDriver driver, Class<? extends AbstractButton> type, String name) {
        AbstractButton button = driver.find(type, name);
        WindowDriver.onEventThread(() -> button.doClick());
    }

    /** Writes a PNG with a palette and without filters, which would make a window a third larger. */
    private static void write(BufferedImage picture, Path file) throws IOException {
        IndexColorModel colours = (IndexColorModel) picture.getColorModel();
        int width = picture.getWidth();
        int height = picture.getHeight();
        ByteBuffer header = ByteBuffer.allocate(13).putInt(width).putInt(height);
        header.put(new byte[] {8, 3, 0, 0, 0});
        ByteBuffer palette = ByteBuffer.allocate(3 * colours.getMapSize());
        for (int i = 0; i < colours.getMapSize(); i++) {
            palette.put((byte) colours.getRed(i))
                    .put((byte) colours.getGreen(i))
                    .put((byte) colours.getBlue(i));
        }
        ByteArrayOutputStream pixels = new ByteArrayOutputStream();
        try (DeflaterOutputStream packed = new DeflaterOutputStream(pixels, new Deflater(Deflater.BEST_COMPRESSION))) {
            for (int row = 0; row < height; row++) {
                packed.write(0);
                for (int column = 0; column < width; column++) {
                    packed.write(picture.getRaster().getSample(column, row, 0));
                }
            }
        }
        Files.createDirectories(file.getParent());
        try (DataOutputStream out = new DataOutputStream(Files.newOutputStream(file))) {
            out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
            writeChunk(out, "IHDR", header.array());
            writeChunk(out, "PLTE", palette.array());
            writeChunk(out, "IDAT", pixels.toByteArray());
            writeChunk(out, "IEND", new byte[0]);
        }
    }

    private static void writeChunk(DataOutputStream out, String type, byte[] content) throws IOException {
        CRC32 check = new CRC32();
        check.update(type.getBytes(StandardCharsets.US_ASCII));
        check.update(content);
        out.writeInt(content.length);
        out.write(type.getBytes(StandardCharsets.US_ASCII));
        out.write(content);
        out.writeInt((int) check.getValue());
    }
}
