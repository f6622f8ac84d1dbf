package tompkins.image;

import java.awt.image.BufferedImage;

/** Draws over a picture that leaves the program. */
@FunctionalInterface
public interface PictureDecoration {

    /** Draws nothing. */
    PictureDecoration NONE = picture -> {};

    /** Draws. */
    void paint(BufferedImage picture);
}
