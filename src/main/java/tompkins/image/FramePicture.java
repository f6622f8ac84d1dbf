package tompkins.image;

import java.awt.image.BufferedImage;
import java.util.function.Consumer;

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

    /**
     * The frame of a photograph.
     *
     * @param curve how its light becomes colours
     * @param decoration draws over it
     * @param caption what is written into its lower left corner; nothing if it is empty
     */
    public static FramePicture of(
            LinearImage photograph, ToneCurve curve, Consumer<FramePicture> decoration, String caption) {
        FramePicture picture = of(photograph, curve);
        decoration.accept(picture);
        if (!caption.isEmpty()) {
            PictureLabel.paint(picture.image, caption);
        }
        return picture;
    }

    /** Its size in pixels: {@code 640 x 480}. */
    public String size() {
        return image.getWidth() + " x " + image.getHeight();
    }
}
