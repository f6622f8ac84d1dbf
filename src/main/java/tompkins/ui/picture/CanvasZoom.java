package tompkins.ui.picture;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;

/**
 * Enlarges the picture of a canvas until the pixels of its photograph can be counted. The place that the mouse or the
 * keys point at stays where it is.
 */
public final class CanvasZoom {

    private final PictureCanvas canvas;

    /** The present zoom; null while the picture fits into its room. */
    private Zoom now;

    CanvasZoom(PictureCanvas canvas) {
        this.canvas = canvas;
    }

    /** The present zoom; null while the picture fits into its room. */
    Zoom now() {
        return now;
    }

    /** Enlarges the picture by a step, which first shows it in its own pixels. */
    public void enlarge() {
        Picture picture = canvas.shown().now();
        if (picture != null) {
            Point2D middle = now == null
                    ? new Point2D.Double(picture.ownWidth() / 2.0, picture.ownHeight() / 2.0)
                    : now.middle();
            Zoom larger = Zoom.beyond(now == null ? fittingScale(picture) : now.side(), middle);
            if (larger != null) {
                change(larger);
            }
        }
    }

    /** Makes the picture smaller by a step, until it fits into its room. */
    public void reduce() {
        if (now != null) {
            change(now.smaller(fittingScale(canvas.shown().now())));
        }
    }

    /** Lets the picture fit into its room. */
    public void fit() {
        if (now != null) {
            change(null);
        }
    }

    /** The width of a pixel of the photograph in pixels of the screen when it fits into its room. */
    private double fittingScale(Picture picture) {
        return (double) canvas.arrangement().fitted().width / picture.ownWidth();
    }

    private void change(Zoom next) {
        PictureArrangement before = canvas.arrangement();
        Point2D place = canvas.pointedPlace();
        now = next == null || place == null
                ? next
                : next.with(place, before.pointOf(place), before.room().getSize());
        canvas.zoomed();
    }

    /** Moves the enlarged picture by a distance on the canvas. */
    void pan(int right, int down) {
        if (now != null) {
            PictureArrangement before = canvas.arrangement();
            Rectangle bounds = before.bounds();
            double scale = canvas.scale();
            bounds.translate((int) Math.round(right * scale), (int) Math.round(down * scale));
            now = now.with(
                    new Point2D.Double(), bounds.getLocation(), before.room().getSize());
            canvas.repaint();
        }
    }

    /** Moves the enlarged picture, if necessary, until a place of the photograph is visible. */
    void show(Point2D place) {
        if (now != null) {
            PictureArrangement before = canvas.arrangement();
            Point at = before.pointOf(place);
            if (!before.room().contains(at)) {
                now = new Zoom(now.side(), place);
            }
        }
    }
}
