package tompkins.image;

import java.awt.image.BufferedImage;

/**
 * A photograph, or a frame of a film, as a screen shows it.
 *
 * @param image of type {@link BufferedImage#TYPE_INT_RGB}
 */
public record FramePicture(BufferedImage image) {

    /** A photograph. */
    public static FramePicture of(LinearImage photograph, ToneCurve curve) {
        return new FramePicture(BufferedImages.toBufferedImage(photograph, curve));
    }

    /**
     * A picture whose levels are known.
     *
     * @param levels those of {@link LevelTable#levels}, row by row
     */
    public static FramePicture of(int width, int height, int[] levels) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        image.getRaster().setDataElements(0, 0, width, height, levels);
        return new FramePicture(image);
    }

    /** Its size in pixels: {@code 640 x 480}. */
    public String size() {
        return image.getWidth() + " x " + image.getHeight();
    }
}
