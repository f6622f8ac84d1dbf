package tompkins.ui.picture;

import java.awt.Dimension;
import tompkins.studio.RenderSettings;

/**
 * The room that there is for each picture, in pixels of the screen, and how the picture uses it.
 *
 * @param size the room
 * @param ownPixels whether the picture should have the pixels of the photograph; otherwise it has the size of the room
 * @param filled whether the picture may fill the room so that its edges are cut off; otherwise it fits into it
 */
public record Room(Dimension size, boolean ownPixels, boolean filled) {

    /** Of a picture that fills a room half is seen; the gap between two rooms makes that a little less. */
    private static final double MOST_CUT = 2.1;

    /** The size that the picture of a photograph should have, in its own pixels. */
    public Dimension sizeOf(RenderSettings photograph) {
        return ownPixels
                ? new Dimension(photograph.width(), photograph.height())
                : shown(photograph.width(), photograph.height());
    }

    /** The size of a picture of the given proportions that is not enlarged. */
    Dimension shown(int width, int height) {
        double across = (double) size.width / width;
        double down = (double) size.height / height;
        double fitting = Math.min(across, down);
        double filling = Math.max(across, down);
        double scale = filled && filling <= MOST_CUT * fitting ? filling : fitting;
        return new Dimension(
                Math.max(1, (int) Math.round(width * scale)), Math.max(1, (int) Math.round(height * scale)));
    }
}
