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
                : fitting(photograph.width(), photograph.height(), size);
    }

    /** The largest size of a picture of the given proportions in a room. */
    static Dimension fitting(int width, int height, Dimension room) {
        double scale = Math.min((double) room.width / width, (double) room.height / height);
        return new Dimension(
                Math.max(1, (int) Math.round(width * scale)), Math.max(1, (int) Math.round(height * scale)));
    }
}
