package tompkins.image;

import java.awt.image.BufferedImage;

/**
 * A frame of a film as a screen shows it.
 *
 * @param image of type {@link BufferedImage#TYPE_INT_RGB}
 */
public record FramePicture(BufferedImage image) {

    /**
     * The frame of a photograph.
     *
     * @param curve how its light becomes colours
     * @param decoration draws over it
     * @param caption what is written into its lower left corner; nothing if it is empty
     */
    public static FramePicture of(
            LinearImage photograph, ToneCurve curve, PictureDecoration decoration, String caption) {
        BufferedImage image = BufferedImages.toBufferedImage(photograph, curve);
        decoration.paint(image);
        if (!caption.isEmpty()) {
            PictureLabel.paint(image, caption);
        }
        return new FramePicture(image);
    }

    /** Its size in pixels: {@code 640 x 480}. */
    public String size() {
        return image.getWidth() + " x " + image.getHeight();
    }
}
