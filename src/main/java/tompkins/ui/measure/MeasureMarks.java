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
import tompkins.ui.ray.LabelPlacer;

/** What is measured in pictures: points with their names, lines, and what was fitted to them. */
public final class MeasureMarks implements Overlay {

    private static final Color COLOUR = new Color(120, 255, 255);
    private static final double INNER = 2;
    private static final double OUTER = 8;

    /** Names are so far apart, and no name is more than so many lines away from its point. */
    private static final int GAP = 16;

    private static final int MOST_LINES = 4;

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
        List<Marked> marks = picture == otherPicture.get() ? other : now;
        List<Line2D> lines = new ArrayList<>();
        for (Marked marked : marks) {
            List<Line2D> own = lines(marked.sketch, toScreen);
            Path2D shape = new Path2D.Double();
            own.forEach(line -> shape.append(line, false));
            Mark.paintLines(g, shape, COLOUR, false);
            lines.addAll(own);
        }
        LabelPlacer placer = new LabelPlacer(visible, lines);
        for (Marked marked : marks) {
            List<Point2D> named = named(marked.sketch, toScreen);
            for (int i = 0; i < Math.min(named.size(), marked.names.size()); i++) {
                write(g, marked.names.get(i), named.get(i), visible, placer);
            }
        }
    }

    private static Point2D onScreen(Vector2dc place, AffineTransform toScreen) {
        return toScreen.transform(new Point2D.Double(place.x(), place.y()), null);
    }

    /** All that is drawn: lines, and a cross at each point. */
    private static List<Line2D> lines(Sketch sketch, AffineTransform toScreen) {
        List<Line2D> lines = new ArrayList<>();
        for (List<Vector2dc> line : sketch.lines()) {
            for (int i = 1; i < line.size(); i++) {
                lines.add(new Line2D.Double(onScreen(line.get(i - 1), toScreen), onScreen(line.get(i), toScreen)));
            }
        }
        for (Vector2dc place : sketch.points()) {
            Point2D point = onScreen(place, toScreen);
            double x = point.getX();
            double y = point.getY();
            for (int side = -1; side <= 1; side += 2) {
                lines.add(new Line2D.Double(x + side * INNER, y, x + side * OUTER, y));
                lines.add(new Line2D.Double(x, y + side * INNER, x, y + side * OUTER));
            }
        }
        return lines;
    }

    /** Where names belong: points, or without any the highest place of the lines. */
    private static List<Point2D> named(Sketch sketch, AffineTransform toScreen) {
        if (!sketch.points().isEmpty()) {
            return sketch.points().stream()
                    .map(point -> onScreen(point, toScreen))
                    .toList();
        }
        Path2D shape = new Path2D.Double();
        lines(sketch, toScreen).forEach(line -> shape.append(line, false));
        Rectangle2D bounds = shape.getBounds2D();
        return List.of(new Point2D.Double(bounds.getCenterX(), bounds.getY()));
    }

    /**
     * Writes beside a point where nothing is in the way: above it or below, to the right or to the left, and farther
     * away, at the end of a thin line.
     */
    private static void write(Graphics2D g, String text, Point2D point, Rectangle visible, LabelPlacer placer) {
        Font font = UIManager.getFont("small.font");
        FontMetrics metrics = g.getFontMetrics(font);
        int height = metrics.getHeight();
        int width = metrics.stringWidth(text) + GAP;
        List<Rectangle2D> places = new ArrayList<>();
        for (int line = 0; line < MOST_LINES; line++) {
            for (int side = -1; side <= 1; side += 2) {
                double y = point.getY() + side * (OUTER + 1 + line * height) - (side < 0 ? height : 0);
                for (double x : new double[] {point.getX() + OUTER, point.getX() - OUTER - width}) {
                    double inside = Math.max(visible.x, Math.min(x, visible.getMaxX() - width));
                    places.add(new Rectangle2D.Double(inside, y, width, height));
                }
            }
        }
        Rectangle2D room = placer.take(places);
        double side = Math.signum(room.getCenterY() - point.getY());
        double start = point.getY() + side * OUTER;
        if (Math.abs(room.getCenterY() - start) > height) {
            Mark.paintLines(g, new Line2D.Double(point.getX(), start, point.getX(), room.getCenterY()), COLOUR, true);
        }
        Mark.paintText(g, font, text, room.getX() + GAP / 2.0, room.getY() + metrics.getAscent(), COLOUR);
    }
}
