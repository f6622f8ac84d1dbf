package tompkins.ui.measure;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.UIManager;
import org.joml.Vector2dc;
import tompkins.measure.LessonResult;
import tompkins.measure.Sketch;
import tompkins.ui.picture.Mark;
import tompkins.ui.picture.Overlay;
import tompkins.ui.picture.Picture;

/** What is measured in pictures: points with their names, lines, and what was fitted to them. */
public final class MeasureMarks implements Overlay {

    private static final Color COLOUR = new Color(120, 255, 255);
    private static final double INNER = 2;
    private static final double OUTER = 8;

    /**
     * What is marked in one picture, in pixels of its photograph.
     *
     * @param sketch points and lines
     * @param names what the first points are called, or the first line where there are no points
     */
    public record Marked(Sketch sketch, List<String> names) {}

    private final Supplier<Picture> otherPicture;
    private List<Marked> now = List.of();
    private List<Marked> other = List.of();

    /** Marks nothing yet; {@code otherPicture} is that with which the picture is compared, or null. */
    public MeasureMarks(Supplier<Picture> otherPicture) {
        this.otherPicture = otherPicture;
    }

    /** Marks this from now on, in the picture and in that with which it is compared. */
    public void show(List<Marked> inPicture, List<Marked> inOther) {
        now = inPicture;
        other = inOther;
    }

    /** Marks where numbers of a lesson were measured from now on. */
    public void show(List<LessonResult> results) {
        List<Marked> marks = new ArrayList<>();
        for (LessonResult result : results) {
            if (!result.sketch().equals(Sketch.EMPTY)) {
                marks.add(new Marked(result.sketch(), List.of(result.number().name())));
            }
        }
        show(marks, List.of());
    }

    @Override
    public boolean isOfAllPictures() {
        return true;
    }

    @Override
    public void paint(Graphics2D g, Picture picture, Rectangle bounds, Rectangle visible, Rectangle free) {
        AffineTransform toScreen = AffineTransform.getTranslateInstance(bounds.x, bounds.y);
        toScreen.scale((double) bounds.width / picture.ownWidth(), (double) bounds.height / picture.ownHeight());
        List<Rectangle2D> written = new ArrayList<>();
        for (Marked marked : picture == otherPicture.get() ? other : now) {
            paint(g, marked, toScreen, visible, written);
        }
    }

    private static void paint(
            Graphics2D g, Marked marked, AffineTransform toScreen, Rectangle visible, List<Rectangle2D> written) {
        Path2D shape = new Path2D.Double();
        for (List<Vector2dc> line : marked.sketch.lines()) {
            shape.moveTo(line.get(0).x(), line.get(0).y());
            line.forEach(place -> shape.lineTo(place.x(), place.y()));
        }
        shape.transform(toScreen);
        List<Point2D> points = new ArrayList<>();
        for (Vector2dc point : marked.sketch.points()) {
            points.add(toScreen.transform(new Point2D.Double(point.x(), point.y()), null));
        }
        List<Point2D> named = points.isEmpty() ? List.of(highest(shape)) : points;
        for (Point2D point : points) {
            for (int side = -1; side <= 1; side += 2) {
                double x = point.getX();
                double y = point.getY();
                shape.append(new Line2D.Double(x + side * INNER, y, x + side * OUTER, y), false);
                shape.append(new Line2D.Double(x, y + side * INNER, x, y + side * OUTER), false);
            }
        }
        Mark.paintLines(g, shape, COLOUR, false);
        for (int i = 0; i < Math.min(named.size(), marked.names.size()); i++) {
            write(g, marked.names.get(i), named.get(i), visible, written);
        }
    }

    private static Point2D highest(Path2D shape) {
        Rectangle2D bounds = shape.getBounds2D();
        return new Point2D.Double(bounds.getCenterX(), bounds.getY());
    }

    /**
     * Writes above a point, so that its line crosses no words, and higher where something is written already; below it
     * at the upper edge of what is seen.
     */
    private static void write(Graphics2D g, String text, Point2D point, Rectangle visible, List<Rectangle2D> written) {
        Font font = UIManager.getFont("small.font");
        FontMetrics metrics = g.getFontMetrics(font);
        int height = metrics.getHeight();
        double x = Math.min(point.getX() + OUTER, visible.getMaxX() - metrics.stringWidth(text) - OUTER);
        boolean above = point.getY() - OUTER - height >= visible.y;
        double y = point.getY() + (above ? -OUTER - height : OUTER);
        Rectangle2D room = new Rectangle2D.Double(Math.max(x, visible.x), y, metrics.stringWidth(text), height);
        while (written.stream().anyMatch(room::intersects)) {
            room.setRect(room.getX(), room.getY() + (above ? -height : height), room.getWidth(), height);
        }
        written.add(room);
        Mark.paintText(g, font, text, room.getX(), room.getY() + metrics.getAscent(), COLOUR);
    }
}
