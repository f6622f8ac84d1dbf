package tompkins.image;

import java.awt.Font;
import java.awt.image.BufferedImage;
import tompkins.file.FileException;

/** Whether there are fonts: a small system may come without any. */
public final class Fonts {

    private Fonts() {}

    /**
     * Refuses work that writes into pictures if there is no font for it.
     *
     * @throws FileException if there is none; the message names the packages that are missing
     */
    public static void require() throws FileException {
        try {
            new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
                    .createGraphics()
                    .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 12))
                    .stringWidth("0");
        } catch (RuntimeException | LinkageError | InternalError missing) {
            throw new FileException(
                    "there is no font to write into the picture: install the packages fontconfig and fonts-dejavu-core"
                            + " (dejavu-sans-fonts in Fedora)",
                    missing);
        }
    }
}
