package tompkins.ui.picture;

import java.awt.Graphics2D;
import java.awt.Rectangle;

/** Something that is painted over a picture on the screen and is not part of it. */
public interface Overlay {

    /**
     * Paints it.
     *
     * @param picture the picture on the screen
     * @param bounds where that lies; larger than the canvas if it is enlarged
     * @param visible the part of it that is seen
     * @param free the part of that which lies between titles and captions
     */
    void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free);

    /** Whether it is painted over both pictures if two are shown, and not only over the studio's. */
    default boolean isOfAllPictures() {
        return false;
    }
}
