package tompkins.ui.overlay;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import javax.swing.UIManager;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Aim.PicturePosition;
import tompkins.studio.Studio;
import tompkins.ui.picture.Mark;
import tompkins.ui.picture.Overlay;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Drawing;
import tompkins.ui.widget.Texts;

/**
 * Where the camera flies, and where it comes from: a ring with a point for the one, a ring with a cross for the other,
 * like the head and the tail of an arrow.
 */
public final class VelocityArrow implements Overlay {

    private static final double RADIUS = 10;

    /** Room for the black edge of a text. */
    private static final int EDGE = 2;

    private boolean shown;

    /** Paints the arrow from now on, or not. */
    public void setShown(boolean show) {
        shown = show;
    }

    @Override
    public void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        Studio studio = picture.studio();
        if (!shown || studio.velocity().isRest() || picture.plan().isAtRest()) {
            return;
        }
        Vector3dc ahead = studio.velocity().direction();
        List<Vector2dc> heads = places(picture, ahead, bounds, visible);
        List<Vector2dc> tails = places(picture, new Vector3d().sub(ahead), bounds, visible);
        heads.forEach(head -> paintHead(g, head));
        tails.forEach(tail -> paintTail(g, tail));
        labels(g, Texts.get("arrow.ahead"), heads, visible);
        labels(g, Texts.get("arrow.back"), tails, visible);
    }

    /** Where each eye sees a direction, as far as it is visible. */
    private static List<Vector2dc> places(Picture picture, Vector3dc direction, Rectangle bounds, Rectangle visible) {
        int width = picture.ownWidth();
        int height = picture.ownHeight();
        List<Vector2dc> places = new ArrayList<>();
        for (Vector2dc place : PicturePosition.of(picture.studio().camera(), direction, width, height)) {
            double x = bounds.x + place.x() / width * bounds.width;
            double y = bounds.y + place.y() / height * bounds.height;
            if (visible.contains(x, y)) {
                places.add(new Vector2d(x, y));
            }
        }
        return places;
    }

    private static void paintHead(Graphics2D g, Vector2dc place) {
        Path2D mark = ring(place);
        mark.append(Drawing.circle(place.x(), place.y(), 1.5), false);
        Mark.paint(g, mark);
    }

    private static void paintTail(Graphics2D g, Vector2dc place) {
        double arm = RADIUS * Math.sqrt(0.5);
        Path2D mark = ring(place);
        mark.append(new Line2D.Double(place.x() - arm, place.y() - arm, place.x() + arm, place.y() + arm), false);
        mark.append(new Line2D.Double(place.x() - arm, place.y() + arm, place.x() + arm, place.y() - arm), false);
        Mark.paint(g, mark);
    }

    private static Path2D ring(Vector2dc place) {
        return new Path2D.Double(Drawing.circle(place.x(), place.y(), RADIUS));
    }

    /**
     * Writes below the rings, because what is measured has its name above; to the left where the right has no room.
     * Where the eyes look into one picture, their rings lie side by side and share a text.
     */
    private static void labels(Graphics2D g, String text, List<Vector2dc> places, Rectangle visible) {
        Font font = UIManager.getFont("small.font");
        int width = g.getFontMetrics(font).stringWidth(text);
        List<Vector2dc> ordered =
                places.stream().sorted(Comparator.comparingDouble(Vector2dc::x)).toList();
        for (int i = 0; i < ordered.size(); i++) {
            Vector2dc place = ordered.get(i);
            if (i == ordered.size() - 1 || place.distance(ordered.get(i + 1)) > width + 2 * RADIUS) {
                double right = place.x() + RADIUS;
                double x = right + width + EDGE < visible.getMaxX() ? right : place.x() - RADIUS - width;
                Mark.paintText(g, font, text, x, place.y() + RADIUS + font.getSize2D() / 2);
            }
        }
    }
}
