package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;

/**
 * Where on the canvas which picture is seen.
 *
 * @param shown the pictures
 * @param comparison how the two are shown
 * @param otherAlone whether the other one is shown alone, if there is one
 * @param divider where the two are split, from 0 at the left edge of the picture to 1
 * @param canvas the size of the canvas
 */
record PictureArrangement(
        ScreenPicture shown, Comparison comparison, boolean otherAlone, double divider, Dimension canvas) {

    /** Between two pictures beside each other. */
    private static final int GAP = 8;

    /** Where the picture lies on the canvas. */
    Rectangle bounds() {
        Picture picture = shown.now();
        return picture == null
                ? new Rectangle(0, 0, room(), canvas.height)
                : Fit.place(picture.image().width(), picture.image().height(), room(), canvas.height);
    }

    /** Where the other picture lies, of the same size. */
    Rectangle otherBounds() {
        Rectangle bounds = bounds();
        if (isBeside()) {
            bounds.x += canvas.width - room();
        }
        return bounds;
    }

    /** Where the picture, or the one beside it, lies that is seen at a point of the canvas; null if none is. */
    Rectangle boundsAt(Point point) {
        Rectangle bounds = isOverOther(point) ? otherBounds() : bounds();
        return shown.now() == null || !bounds.contains(point) ? null : bounds;
    }

    /** Whether there is room for two beside each other. */
    boolean isBeside() {
        return comparison == Comparison.BESIDE && !otherAlone;
    }

    /** The width that there is for each picture. */
    int room() {
        return isBeside() ? Math.max(1, (canvas.width - GAP) / 2) : canvas.width;
    }

    /** Whether two pictures are seen. */
    boolean showsTwo() {
        return splits() || isBeside() && shown.otherImage() != null;
    }

    /** Whether a divider is seen. */
    boolean splits() {
        return comparison == Comparison.SPLIT && shown.otherImage() != null && !otherAlone;
    }

    /** Whether the other picture alone is seen. */
    boolean showsOtherAlone() {
        return otherAlone && shown.otherImage() != null;
    }

    /** Whether the difference of both is seen. */
    boolean showsDifference() {
        return comparison == Comparison.DIFFERENCE && shown.difference() != null && !otherAlone;
    }

    /** Where the divider is on the canvas. */
    int dividerX() {
        Rectangle bounds = bounds();
        return bounds.x + (int) Math.round(divider * bounds.width);
    }

    private boolean isOverOther(Point point) {
        return isBeside() && shown.otherImage() != null && otherBounds().contains(point);
    }

    /**
     * The middle of the pixel of the picture, or of the one beside it, at a point of the canvas; null if there is none.
     */
    Point2D pictureAt(Point point) {
        Rectangle bounds = isOverOther(point) ? otherBounds() : bounds();
        if (shown.now() == null || !bounds.contains(point)) {
            return null;
        }
        double scale = (double) shown.now().image().width() / bounds.width;
        int right = shown.now().image().width() - 1;
        int bottom = shown.now().image().height() - 1;
        int column = Math.min(right, (int) ((point.x + 0.5 - bounds.x) * scale));
        int row = Math.min(bottom, (int) ((point.y + 0.5 - bounds.y) * scale));
        return new Point2D.Double(column + 0.5, row + 0.5);
    }

    /** The picture that is seen at a point of the canvas, beyond the divider the other one; null if there is none. */
    Picture shownAt(Point point) {
        Point2D place = pictureAt(point);
        if (place == null) {
            return null;
        }
        return isOverOther(point) ? shown.other() : seenAt(place);
    }

    /** The picture that is seen at a place of the present one. */
    Picture seenAt(Point2D place) {
        boolean beyond =
                splits() && place.getX() > divider * shown.now().image().width();
        return beyond || showsOtherAlone() ? shown.other() : shown.now();
    }
}
