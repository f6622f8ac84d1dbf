package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.Rectangle;

/** Where a picture lies in a canvas: as large as possible, in its own proportions, in the middle. */
final class Fit {

    private Fit() {}

    /** The largest size of a picture of the given proportions in a canvas. */
    static Dimension size(int width, int height, int canvasWidth, int canvasHeight) {
        double scale = Math.min((double) canvasWidth / width, (double) canvasHeight / height);
        return new Dimension(
                Math.max(1, (int) Math.round(width * scale)), Math.max(1, (int) Math.round(height * scale)));
    }

    /** The place of a picture of the given proportions in a canvas. */
    static Rectangle place(int width, int height, int canvasWidth, int canvasHeight) {
        Dimension size = size(width, height, canvasWidth, canvasHeight);
        return new Rectangle((canvasWidth - size.width) / 2, (canvasHeight - size.height) / 2, size.width, size.height);
    }
}
