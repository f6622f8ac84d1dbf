package tompkins.ui.picture;

import java.awt.Graphics2D;
import java.awt.Rectangle;

/** Something that is painted over a picture on the screen, and is no part of it. */
public interface Overlay {

    /**
     * Paints it.
     *
     * @param picture the picture on the screen
     * @param bounds where that lies; beyond the canvas where it is enlarged
     * @param visible the part of it that is seen
     * @param free the part of that at whose edges nothing is written, where two pictures are compared
     */
    void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free);

    /** Whether it is painted over each picture where two are seen, and not over the studio's alone. */
    default boolean isOfAllPictures() {
        return false;
    }
}
