package tompkins.ui.picture;

import java.awt.Dimension;
import tompkins.studio.RenderSettings;

/**
 * The room that there is for each picture, in pixels of the screen, and whether its pixels should be seen one by one.
 *
 * @param size the room
 * @param ownPixels whether the picture should have the pixels of the photograph; otherwise it fits into the room
 */
public record Room(Dimension size, boolean ownPixels) {

    /** The size that the picture of a photograph should have, in its own pixels. */
    public Dimension sizeOf(RenderSettings photograph) {
        return ownPixels
                ? new Dimension(photograph.width(), photograph.height())
                : Fit.size(photograph.width(), photograph.height(), size.width, size.height);
    }
}
