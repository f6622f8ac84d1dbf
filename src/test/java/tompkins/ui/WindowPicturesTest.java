package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButton;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTextPane;
import javax.swing.JToggleButton;
import org.joml.Vector2dc;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.io.BundledScenes;
import tompkins.io.StudioReader;
import tompkins.measure.MeasureKind;
import tompkins.measure.OverlayKind;
import tompkins.measure.Overlays;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.studio.Studio;
import tompkins.ui.panel.ComparePanel;
import tompkins.ui.panel.RidePilot;
import tompkins.ui.picture.PictureCanvas;
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

    private static final long LARGEST = 200_000;

    /** The pictures. */
    enum Shot {
        DEFAULT("town-square"),
        DARK("town-square"),
        PROJECTOR("town-square"),
        RIDE("town-square"),
        WIDE_APERTURE("fig3a"),
        SPLIT("fig1b"),
        SIDE_BY_SIDE("terrell-cube"),
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
        if (shot == Shot.WIDE_APERTURE) {
            // without noise, which would make a large file
            studio = studio.withSettings(studio.settings().withSize(320, 240).withSamples(400));
        } else if (shot == Shot.SPLIT || shot == Shot.RIDE) {
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
            if (shot == Shot.WIDE_APERTURE) {
                resize(driver);
            }
            arrange(shot, driver);
            driver.completePicture();
            Thread.sleep(500);
            Rectangle bounds =
                    WindowDriver.onEventThread(() -> driver.window().frame().getBounds());
            BufferedImage picture = new Robot().createScreenCapture(bounds);
            write(
                    switch (shot) {
                        case WIDE_APERTURE -> withoutLowBits(picture, 0xf0);
                        case MEASURING -> withoutLowBits(picture, 0xf8);
                        default -> picture;
                    },
                    shot.file());
        }
    }

    private static void resize(WindowDriver driver) {
        WindowDriver.onEventThread(() -> {
            driver.window().frame().setSize(960, 700);
            driver.window().frame().validate();
        });
    }

    /** The low bits of a blurred picture are noise, and most of its file. */
    private static BufferedImage withoutLowBits(BufferedImage picture, int highBits) {
        int high = highBits * 0x010101;
        int middle = (0x100 - highBits) / 2 * 0x010101;
        BufferedImage plain = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                plain.setRGB(x, y, picture.getRGB(x, y) & high | middle);
            }
        }
        return plain;
    }

    private static void arrange(Shot shot, WindowDriver driver) {
        switch (shot) {
            case DARK, PROJECTOR -> press(driver, JMenuItem.class, "look." + shot.name());
            case RIDE -> ride(driver);
            case SPLIT -> compareWithRest(driver);
            case SIDE_BY_SIDE -> {
                compareWithRest(driver);
                press(driver, JRadioButton.class, "Side by side");
            }
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
        Overlays overlays =
                new Overlays(projection, SceneShapes.of(driver.picture().plan().sceneFrames()));
        List<Vector2dc> outline = overlays.draw(OverlayKind.OUTLINES).lines().get(0);
        Rectangle bounds =
                WindowDriver.onEventThread(() -> driver.window().view().canvas().pictureBounds());
        Point corner =
                WindowDriver.onEventThread(() -> driver.window().view().canvas().getLocationOnScreen());
        for (int i = 0; i < 4; i++) {
            Vector2dc place = outline.get(i * outline.size() / 4);
            driver.click(new Point(
                    corner.x + bounds.x + (int) (place.x() * bounds.width / projection.width()),
                    corner.y + bounds.y + (int) (place.y() * bounds.height / projection.height())));
        }
        JTextArea results = driver.find(JTextArea.class, "measure.results");
        WindowDriver.await("the circle", () -> results.getText().startsWith("half-angle"));
    }

    /** Leads through a lesson to its end. */
    private static void lead(WindowDriver driver) {
        press(driver, JRadioButton.class, "Only the front face, but narrower.");
        press(driver, JRadioButton.class, "I am sure");
        for (String step : List.of("LOOK", "REASON", "MEASURE")) {
            press(driver, JButton.class, Texts.get("lesson.next." + step));
        }
        WindowDriver.await(
                "the numbers",
                () -> Components.labels(driver.window().frame()).anyMatch(Texts.get("lesson.measured")::equals));
    }

    /** A moment of the recorded ride, with all that can be drawn over the picture. */
    private static void ride(WindowDriver driver) {
        press(driver, JMenuItem.class, "menu.map");
        press(driver, JMenuItem.class, "menu.replay");
        RidePilot pilot = driver.window().motion().pilot();
        WindowDriver.await("the thrust", () -> pilot.moment().properTime() > RIDE_TIME);
        WindowDriver.onEventThread(() -> pilot.setRiding(false));
    }

    private static void compareWithRest(WindowDriver driver) {
        press(driver, JToggleButton.class, "Shutter");
        press(driver, JToggleButton.class, "Compare");
        press(driver, JToggleButton.class, "What this picture models");
        JComboBox<?> other = driver.find(JComboBox.class, "Compare with");
        WindowDriver.onEventThread(() -> other.setSelectedItem(ComparePanel.Other.AT_REST));
        PictureCanvas canvas = driver.window().view().canvas();
        WindowDriver.await(
                "the other picture",
                () -> canvas.shown().other() != null && canvas.shown().other().complete());
    }

    private static void press(WindowDriver driver, Class<? extends AbstractButton> type, String name) {
        AbstractButton button = driver.find(type, name);
        WindowDriver.onEventThread(() -> button.doClick());
    }

    private static void write(BufferedImage picture, Path file) throws IOException {
        Files.createDirectories(file.getParent());
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try (ImageOutputStream out = ImageIO.createImageOutputStream(Files.newOutputStream(file))) {
            writer.setOutput(out);
            writer.write(picture);
        } finally {
            writer.dispose();
        }
    }
}
