package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;

/**
 * A photograph that is shown in its own pixels, each as a square of the screen.
 *
 * @param side pixels of the screen in a row of such a square: a power of two
 * @param middle the place of the photograph that should be in the middle of the room
 */
record Zoom(int side, Point2D middle) {

    /** Large enough to count pixels on a projector. */
    private static final int LARGEST = 64;

    /** The smallest zoom with more pixels of the screen than this for each of the photograph; null if none has. */
    static Zoom beyond(double scale, Point2D middle) {
        int side = 1;
        while (side <= scale) {
            side *= 2;
        }
        return side > LARGEST ? null : new Zoom(side, middle);
    }

    /** The next smaller zoom, if it still shows more than a number of pixels of the screen for each; otherwise null. */
    Zoom smaller(double scale) {
        return side / 2 > scale ? new Zoom(side / 2, middle) : null;
    }

    /** The zoom with a place of the photograph at a point of the room. */
    Zoom with(Point2D place, Point at, Dimension room) {
        return new Zoom(
                side,
                new Point2D.Double(
                        place.getX() + (room.width / 2.0 - at.x) / side,
                        place.getY() + (room.height / 2.0 - at.y) / side));
    }

    /** Where a photograph lies in a room: it fills it, or is in its middle if it is smaller. */
    Rectangle place(int width, int height, Dimension room) {
        return new Rectangle(
                start(width * side, room.width, middle.getX()),
                start(height * side, room.height, middle.getY()),
                width * side,
                height * side);
    }

    private int start(int length, int room, double centre) {
        if (length <= room) {
            return (room - length) / 2;
        }
        return (int) Math.max(room - length, Math.min(0, Math.round(room / 2.0 - centre * side)));
    }
}
