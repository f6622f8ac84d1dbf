package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import javax.swing.JMenuBar;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.TestRun;
import tompkins.Thorough;
import tompkins.Waiting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.model.Settings;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;

/** How large the picture in the window is, which pixels it has, and how it is enlarged. */
class PictureSizeTest extends WindowFixture {

    private PictureCanvas canvas;

    @BeforeEach
    void open() {
        Studio lattice = Studios.lattice();
        driver = new WindowDriver(
                folder,
                new FirstScene(
                        lattice.withSettings(
                                lattice.settings().withSize(320, 240).withSamples(1)),
                        null),
                List.of());
        canvas = driver.find(PictureCanvas.class, "picture");
    }

    /** What is to be seen in a part of the screen, or is if everything is tried. */
    private BufferedImage seen(Rectangle part) {
        if (TestRun.THOROUGH) {
            try {
                return new Robot().createScreenCapture(part);
            } catch (AWTException e) {
                throw new IllegalStateException(e);
            }
        }
        return onEventThread(() -> {
            BufferedImage image = new BufferedImage(part.width, part.height, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            Point corner = canvas.getLocationOnScreen();
            graphics.translate(corner.x - part.x, corner.y - part.y);
            canvas.paint(graphics);
            graphics.dispose();
            return image;
        });
    }

    private Rectangle onScreen() {
        return onEventThread(() -> {
            Rectangle bounds = canvas.pictureBounds();
            Point corner = canvas.getLocationOnScreen();
            bounds.translate(corner.x, corner.y);
            return bounds;
        });
    }

    private void awaitPixels(Rectangle part, BufferedImage expected) {
        Waiting.until(
                "the pixels of the picture", () -> Arrays.equals(pixels(seen(part), part), pixels(expected, part)));
    }

    private static int[] pixels(BufferedImage image, Rectangle part) {
        return image.getRGB(0, 0, part.width, part.height, null, 0, part.width);
    }

    /** Nothing is enlarged: each pixel of the screen is a pixel of the picture. */
    @Test
    void thePictureHasThePixelsOfTheScreen() {
        // drawn over the picture
        driver.menu("menu.arrow");
        Picture picture = driver.completePicture();
        Rectangle place = onScreen();
        assertThat(new Dimension(picture.image().width(), picture.image().height()))
                .isEqualTo(place.getSize());
        assertThat(picture.isOfOwnSize()).isFalse();
        awaitPixels(place, picture.levels());
        onEventThread(() -> driver.window().frame().setSize(700, 500));
        Picture smaller = driver.completePicture();
        assertThat(smaller.image().width()).isLessThan(picture.image().width());
        awaitPixels(onScreen(), smaller.levels());
    }

    /** Where + is on the key of =, Ctrl and + is Ctrl, Shift and =. */
    @Test
    void thePictureIsEnlargedByCtrlAndPlus() {
        driver.completePicture();
        Rectangle fitting = onScreen();
        driver.move(new Point(fitting.x + 100, fitting.y + 100));
        driver.click(canvas);
        driver.completePicture();
        double field = driver.studio().camera().horizontalAngleDegrees();
        driver.key(KeyEvent.VK_EQUALS, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
        assertThat(driver.completePicture().isOfOwnSize()).isTrue();
        assertThat(driver.studio().camera().horizontalAngleDegrees()).isEqualTo(field);
    }

    /** The lattice is 320 pixels wide: the first step shows them as squares that are larger than the picture was. */
    @Test
    void thePictureIsEnlargedToItsOwnPixelsAndBack() {
        driver.completePicture();
        Rectangle fitting = onScreen();
        Point corner = onEventThread(canvas::getLocationOnScreen);
        Point at = new Point(
                fitting.x + (int) (106.5 * fitting.width / 320), fitting.y + (int) (80.5 * fitting.height / 240));
        driver.move(at);
        await("the pixel", () -> driver.said().startsWith("Pixel 106, 80"));
        driver.key(KeyEvent.VK_EQUALS, KeyEvent.VK_CONTROL);
        Picture own = driver.completePicture();
        assertThat(own.isOfOwnSize()).isTrue();
        driver.key(KeyEvent.VK_EQUALS, KeyEvent.VK_CONTROL);
        Rectangle enlarged = onScreen();
        int side = enlarged.width / own.image().width();
        assertThat(enlarged.getSize()).isEqualTo(new Dimension(side * 320, side * 240));
        assertThat(side).isGreaterThan(fitting.width / 320).isIn(4, 8, 16);
        await("the same pixel", () -> driver.said().startsWith("Pixel 106, 80"));
        BufferedImage levels = own.levels();
        BufferedImage square = new BufferedImage(side, 1, BufferedImage.TYPE_INT_RGB);
        for (int x = 0; x < side; x++) {
            square.setRGB(x, 0, levels.getRGB(106, 80));
        }
        awaitPixels(new Rectangle(enlarged.x + 106 * side, enlarged.y + 80 * side + side / 2, side, 1), square);
        assertThat(corner.x + 0.0).as("some of it is out of sight").isGreaterThan(enlarged.x);
        driver.key(KeyEvent.VK_0, KeyEvent.VK_CONTROL);
        driver.completePicture();
        assertThat(onScreen()).isEqualTo(fitting);
    }

    @Test
    @Thorough
    void thePictureFillsTheScreenAndKeysWorkThere() {
        driver.completePicture();
        Rectangle window = onEventThread(() -> driver.window().frame().getBounds());
        JMenuBar menus = driver.window().frame().getJMenuBar();
        driver.key(KeyEvent.VK_F11);
        Rectangle screen = onEventThread(
                () -> driver.window().frame().getGraphicsConfiguration().getBounds());
        await("the full screen", () -> canvas.getSize().equals(screen.getSize()));
        assertThat(menus.isShowing()).isFalse();
        driver.key(KeyEvent.VK_F7);
        await("a key of the menus", () -> new Settings().number("caption", 0) == 1);
        driver.key(KeyEvent.VK_F12);
        await("the panel", () -> canvas.getWidth() < screen.width);
        driver.key(KeyEvent.VK_ESCAPE);
        await("the window", () -> driver.window().frame().getBounds().equals(window));
        assertThat(menus.isShowing()).isTrue();
    }
}
