package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import tompkins.image.PictureLabel.Corner;

class PictureLabelTest {

    private static final String TEXT = "\u03b2 = 0.826, \u03b3 = 1.77, on board 4.6, scene 5.2";
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.BOLD, 20);

    /** The box around what was painted on white, in a picture of a width. */
    private static Rectangle painted(String text, int width, Corner corner) {
        BufferedImage picture = new BufferedImage(width, 80, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, width, 80);
        PictureLabel.paint(graphics, FONT, text, new Rectangle(width, 80), corner);
        graphics.dispose();
        Rectangle box = new Rectangle(0, 0, -1, -1);
        for (int x = 0; x < width; x++) {
            for (int y = 0; y < 80; y++) {
                if (picture.getRGB(x, y) != Color.WHITE.getRGB()) {
                    box.add(x, y);
                }
            }
        }
        return box;
    }

    @Test
    void aTextBecomesSmallerBeforeItIsCut() {
        Rectangle whole = painted(TEXT, 800, Corner.TOP_MIDDLE);
        Rectangle smaller = painted(TEXT, 400, Corner.TOP_MIDDLE);
        assertThat(whole.width).isGreaterThan(400);
        // the same text in the same type, only smaller: the box has the same proportions
        assertThat((double) smaller.width / smaller.height)
                .isBetween(0.9 * whole.width / whole.height, 1.1 * whole.width / whole.height);
        assertThat(smaller.height).isLessThan(whole.height);
    }

    /** What is least important stands last; what is left ends with a word. */
    @Test
    void aTextWithoutRoomGivesUpItsLastParts() {
        Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        FontMetrics metrics = graphics.getFontMetrics(FONT);
        String text = "Point at the picture; click to follow.";
        int all = metrics.stringWidth(text);
        assertThat(PictureLabel.shortened(text, metrics, all)).isEqualTo(text);
        assertThat(PictureLabel.shortened(text, metrics, all - 1)).isEqualTo("Point at the picture");
        assertThat(PictureLabel.shortened(text, metrics, metrics.stringWidth("Point at the pict\u2026")))
                .isEqualTo("Point at the\u2026");
        assertThat(PictureLabel.shortened(
                        "Pixel 1, 2  \u00b7  wall  \u00b7  far",
                        metrics,
                        metrics.stringWidth("Pixel 1, 2  \u00b7  wall")))
                .isEqualTo("Pixel 1, 2  \u00b7  wall");
        assertThat(PictureLabel.shortened("Superluminal", metrics, metrics.stringWidth("Super\u2026")))
                .isEqualTo("Super\u2026");
        graphics.dispose();
    }

    /** Parts that have no room beside each other stand below each other, in their usual size. */
    @Test
    void partsGoIntoAsManyLinesAsTheyNeed() {
        Graphics2D graphics = new BufferedImage(800, 400, BufferedImage.TYPE_INT_RGB).createGraphics();
        int line = PictureLabel.height(graphics, FONT);
        List<String> parts = List.of("\u03b2 = 0.826, \u03b3 = 1.77", "on board 4.6, scene 5.2", "31 pictures/s");
        List<Integer> lines = new ArrayList<>();
        for (int width : new int[] {800, 550, 300, 100}) {
            Rectangle below = PictureLabel.paintParts(graphics, FONT, parts, new Rectangle(10, 20, width, 400));
            assertThat(below).isEqualTo(new Rectangle(10, below.y, width, 420 - below.y));
            assertThat((below.y - 20) % line).isZero();
            lines.add((below.y - 20) / line);
        }
        graphics.dispose();
        assertThat(lines).containsExactly(1, 2, 3, 5);
    }

    /** Beside each other two labels look alike, unless one had to become very small. */
    @Test
    void labelsOfOnePictureHaveOneSize() {
        Graphics2D graphics = new BufferedImage(800, 400, BufferedImage.TYPE_INT_RGB).createGraphics();
        assertThat(PictureLabel.common(graphics, FONT, Map.of("Now", 400, TEXT, 800)))
                .isEqualTo(FONT);
        float both = PictureLabel.common(graphics, FONT, Map.of("Now", 400, TEXT, 450))
                .getSize2D();
        assertThat(both).isBetween(13f, 18f);
        assertThat(PictureLabel.common(graphics, FONT, Map.of("Now", 400, TEXT, 60))
                        .getSize2D())
                .isEqualTo(12f);
        graphics.dispose();
    }

    /** Whatever stands in it, a label stays in its picture. */
    @Test
    void aLabelStaysInThePicture() {
        for (int width = 20; width < 600; width += 20) {
            for (Corner corner : Corner.values()) {
                Rectangle box = painted(TEXT, width, corner);
                assertThat(box.x).as(width + " " + corner).isNotNegative();
                assertThat(box.getMaxX()).as(width + " " + corner).isLessThan(width);
            }
        }
    }
}
