package tompkins.ui.picture;

import java.awt.Cursor;
import java.awt.geom.Point2D;

/** What a hand does in the picture. Of all tools the first that is wanted is in the hand. */
public interface PictureTool {

    /** Whether it is wanted. */
    boolean isWanted();

    /** What a click does, in a sentence; empty if there may be something better to say. */
    default String hint() {
        return "";
    }

    /** The cursor over the picture, by its number in {@link Cursor}. */
    default int cursor() {
        return Cursor.DEFAULT_CURSOR;
    }

    /**
     * A click.
     *
     * @param place where, in pixels of the photograph
     * @param seen the picture that is seen there, which may be the other one
     */
    void click(Point2D place, Picture seen);

    /**
     * What was taken for a click was the first half of a double click.
     *
     * @return whether the tool has a use for the second half; otherwise the camera turns there
     */
    default boolean clickAgain(Point2D place, Picture seen) {
        return false;
    }
}
