package tompkins.ui.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.UIManager;
import org.joml.Vector2dc;

/** The places between which the user measures, with their numbers, and what was fitted to them. */
public final class MeasureMarks implements Overlay {

    private static final Color COLOUR = new Color(120, 255, 255);
    private static final double INNER = 2;
    private static final double OUTER = 8;

    /**
     * What is marked in one picture, in pixels of its photograph.
     *
     * @param places the places between which is measured
     * @param lines what was fitted to them
     */
    public record Marked(List<Point2D> places, List<List<Vector2dc>> lines) {

        /** Keeps a copy of the places. */
        public Marked {
            places = List.copyOf(places);
        }
    }

    private static final Marked NOTHING = new Marked(List.of(), List.of());

    private final Supplier<Picture> otherPicture;
    private Marked now = NOTHING;
    private Marked other = NOTHING;

    /** Marks nothing yet; {@code otherPicture} is that with which the picture is compared, or null. */
    public MeasureMarks(Supplier<Picture> otherPicture) {
        this.otherPicture = otherPicture;
    }

    /** Marks this from now on, in the picture and in that with which it is compared. */
    public void show(Marked inPicture, Marked inOther) {
        now = inPicture;
        other = inOther;
    }

    @Override
    public boolean isOfAllPictures() {
        return true;
    }

    @Override
    public void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        Marked marked = picture == otherPicture.get() ? other : now;
        List<Point2D> places = marked.places;
        if (places.isEmpty()) {
            return;
        }
        double scaleX = (double) bounds.width / picture.ownWidth();
        double scaleY = (double) bounds.height / picture.ownHeight();
        Path2D marks = new Path2D.Double();
        for (List<Vector2dc> line : marked.lines) {
            marks.moveTo(
                    bounds.x + line.get(0).x() * scaleX, bounds.y + line.get(0).y() * scaleY);
            line.forEach(place -> marks.lineTo(bounds.x + place.x() * scaleX, bounds.y + place.y() * scaleY));
        }
        Font font = UIManager.getFont("small.font");
        for (Point2D place : places) {
            double x = bounds.x + place.getX() * scaleX;
            double y = bounds.y + place.getY() * scaleY;
            for (int side = -1; side <= 1; side += 2) {
                marks.append(new Line2D.Double(x + side * INNER, y, x + side * OUTER, y), false);
                marks.append(new Line2D.Double(x, y + side * INNER, x, y + side * OUTER), false);
            }
        }
        Mark.paintLines(g, marks, COLOUR, false);
        for (int i = 0; i < places.size(); i++) {
            double x = bounds.x + places.get(i).getX() * scaleX + OUTER;
            double y = bounds.y + places.get(i).getY() * scaleY - INNER;
            Mark.paintText(g, font, Integer.toString(i + 1), x, y, COLOUR);
        }
    }
}
