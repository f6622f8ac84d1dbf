package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Wording;

/**
 * Pictures as the screen shows them.
 *
 * @param now the picture, or null
 * @param nowImage the picture as levels, at most in the size in which it is shown
 * @param other what it is compared with, or null
 * @param otherImage the same for the other; null also if it has other proportions
 * @param difference by how much the two differ, or null
 */
public record ScreenPicture(
        Picture now, BufferedImage nowImage, Picture other, BufferedImage otherImage, BufferedImage difference) {

    /** Nothing yet. */
    static final ScreenPicture EMPTY = new ScreenPicture(null, null, null, null, null);

    /** What the picture is called beside the other one: by its shutter, if that is what differs. */
    public String nameOfNow() {
        Class<?> shutter = shutter(now);
        return shutter == shutter(other) ? Texts.get("compare.now") : Wording.label(shutter);
    }

    private static Class<?> shutter(Picture picture) {
        return picture.studio().camera().shutter().getClass();
    }

    /** The same place in another picture: a kept one may have another size. */
    public Point2D placeIn(Picture picture, Point2D place) {
        double scale = (double) picture.ownWidth() / now.ownWidth();
        return new Point2D.Double(scale * place.getX(), scale * place.getY());
    }

    /** An image in another size. */
    static BufferedImage scaled(BufferedImage image, Dimension size) {
        BufferedImage scaled = image;
        // a step to less than half would leave out pixels
        while (scaled.getWidth() >= 2 * size.width && scaled.getHeight() >= 2 * size.height) {
            scaled = drawn(scaled, new Dimension((scaled.getWidth() + 1) / 2, (scaled.getHeight() + 1) / 2));
        }
        return drawn(scaled, size);
    }

    private static BufferedImage drawn(BufferedImage image, Dimension size) {
        if (image.getWidth() == size.width && image.getHeight() == size.height) {
            return image;
        }
        BufferedImage scaled = new BufferedImage(size.width, size.height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = scaled.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        graphics.drawImage(image, 0, 0, size.width, size.height, null);
        graphics.dispose();
        return scaled;
    }

    /** The distance between the levels of two images of the same size, channel by channel: black where they agree. */
    static BufferedImage difference(BufferedImage first, BufferedImage second) {
        int width = first.getWidth();
        int height = first.getHeight();
        BufferedImage difference = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int[] a = new int[width];
        int[] b = new int[width];
        for (int row = 0; row < height; row++) {
            first.getRGB(0, row, width, 1, a, 0, width);
            second.getRGB(0, row, width, 1, b, 0, width);
            for (int column = 0; column < width; column++) {
                a[column] = distance(a[column], b[column]);
            }
            difference.setRGB(0, row, width, 1, a, 0, width);
        }
        return difference;
    }

    private static int distance(int a, int b) {
        int sum = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            sum |= Math.abs((a >> shift & 0xff) - (b >> shift & 0xff)) << shift;
        }
        return sum;
    }
}
