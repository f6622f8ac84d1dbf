package tompkins.ui.ray;

import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.UIManager;
import tompkins.trace.Frame;
import tompkins.ui.widget.Drawing;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

/**
 * Draws the space-time diagram of a ray: the event at the lens in the middle near the top, a unit of x as long as one
 * of time.
 */
@SuppressWarnings("serial") // never written to a stream
final class DiagramPane extends JPanel {

    private static final double HEIGHT = 12.5;

    /** The time that is shown after the ray reached the lens, as a share of the time that is shown before. */
    private static final double AFTER = 0.22;

    /** Room around the events of the ray, as a factor. */
    private static final double ROOM = 1.12;

    private static final double DOT = 0.28;

    /** How far inwards from its end the name of an axis may be, in halves of the height of the type. */
    private static final int STEPS_INWARDS = 8;

    private static final String PRIME = "\u2032";
    private static final float[] DASHES = {3, 4};

    private transient SpaceTimeDiagram diagram;

    /** Empty at first. */
    DiagramPane() {
        Naming.name(this, Texts.get("ray.diagram"), "");
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.pixels(HEIGHT), Look.pixels(HEIGHT));
    }

    /** Shows a diagram; null for none. */
    void show(SpaceTimeDiagram other) {
        diagram = other;
        setVisible(other != null && Double.isFinite(other.reach()));
        if (other != null) {
            Naming.name(this, getName(), Texts.get("ray.diagram." + other.frame() + ".tip"));
        }
        repaint();
    }

    /** Pixels for a unit of length, or of time. */
    private double scale() {
        double reach = diagram.reach() == 0 ? 1 : diagram.reach();
        return Math.min(getWidth() / 2.0, getHeight() / (1 + AFTER)) / (ROOM * reach);
    }

    /** The place in this component of a point of the diagram. */
    private Point2D place(Point2D point) {
        double lensY = getHeight() * AFTER / (1 + AFTER);
        return new Point2D.Double(getWidth() / 2.0 + scale() * point.getX(), lensY - scale() * point.getY());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        Drawing.smooth(g);
        g.setFont(UIManager.getFont("small.font"));
        g.setColor(UIManager.getColor("TextField.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setColor(UIManager.getColor("Tompkins.line"));
        g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
        ownAxes().forEach(g::draw);
        g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, DASHES, 0));
        light().forEach(g::draw);
        g.setStroke(new BasicStroke(1.4f));
        g.setColor(UIManager.getColor("Tompkins.note"));
        otherAxes().forEach(g::draw);
        g.setStroke(new BasicStroke(1));
        words(g.getFontMetrics())
                .forEach((word, place) -> g.drawString(word, (float) place.getX(), (float) place.getMaxY()));
        int gap = g.getFontMetrics().getDescent();
        ticks().forEach(tick -> {
            Point2D at = place(new Point2D.Double(0, tick));
            g.draw(new Line2D.Double(at.getX() - gap, at.getY(), at.getX() + gap, at.getY()));
        });
        g.setColor(UIManager.getColor("Component.accentColor"));
        g.setStroke(new BasicStroke(1.2f));
        object().forEach(g::draw);
        drawRay(g);
        g.dispose();
    }

    private List<Line2D> ownAxes() {
        return List.of(through(new Point2D.Double(1, 0)), through(new Point2D.Double(0, 1)));
    }

    private List<Line2D> light() {
        return diagram.light().stream().map(this::through).toList();
    }

    private List<Line2D> otherAxes() {
        return List.of(through(diagram.otherTime()), through(diagram.otherSpace()));
    }

    /** The worldline of the object at which the ray ends, if there is one. */
    List<Line2D> object() {
        return diagram.object() == null
                ? List.of()
                : List.of(through(diagram.path().get(diagram.path().size() - 1), diagram.object()));
    }

    /** All lines, in pixels. */
    List<Line2D> lines() {
        return Stream.of(ownAxes(), light(), otherAxes(), object(), ray())
                .flatMap(List::stream)
                .toList();
    }

    /**
     * The numbers on the upright axis of time for which there is room, and the names of all axes near their ends; those
     * of the camera have primes. Each with its place in pixels, from the top of its letters to the line they stand on.
     */
    Map<String, Rectangle2D> words(FontMetrics type) {
        boolean ofScene = diagram.frame() == Frame.SCENE;
        String own = ofScene ? "" : PRIME;
        String other = ofScene ? PRIME : "";
        LabelPlacer places = new LabelPlacer(new Rectangle(1, 1, getWidth() - 2, getHeight() - 2), lines());
        Map<String, Rectangle2D> words = new LinkedHashMap<>();
        for (double tick : ticks()) {
            String number = Numbers.brief(tick, 3);
            places.takeFree(besideTick(number, tick, type)).ifPresent(place -> words.put(number, place));
        }
        BiConsumer<String, Point2D> name =
                (text, direction) -> words.put(text, places.take(besideAxis(text, direction, type)));
        name.accept("t" + own, new Point2D.Double(0, 1));
        name.accept("x" + own, new Point2D.Double(1, 0));
        if (diagram.otherTime().getX() != 0) {
            // there is more room below
            name.accept("t" + other, times(diagram.otherTime(), -1));
            name.accept("x" + other, diagram.otherSpace());
        }
        return words;
    }

    /** The times of the marks on the upright axis. */
    private List<Double> ticks() {
        double step = Numbers.niceFloor(diagram.reach() / 2);
        return step > 0
                ? IntStream.rangeClosed(1, (int) (diagram.reach() / step))
                        .mapToObj(i -> -i * step)
                        .toList()
                : List.of();
    }

    /** To the right of a mark on the upright axis, or to the left. */
    private List<Rectangle2D> besideTick(String number, double tick, FontMetrics type) {
        Point2D at = place(new Point2D.Double(0, tick));
        double away = 2 * type.getDescent() + type.stringWidth(number) / 2.0;
        return List.of(
                around(at.getX() + away, at.getY(), number, type), around(at.getX() - away, at.getY(), number, type));
    }

    /**
     * The places beside an axis, from its ends inwards; first those at the end in a given direction, and on the right
     * as seen from the event at the lens.
     */
    private List<Rectangle2D> besideAxis(String name, Point2D direction, FontMetrics type) {
        List<Rectangle2D> places = new ArrayList<>();
        for (int step = 0; step < STEPS_INWARDS; step++) {
            for (Point2D way : List.of(direction, times(direction, -1))) {
                Point2D end = edge(new Point2D.Double(), way, type.getHeight());
                double pixel = 1 / way.distance(0, 0);
                double away = 0.8 * type.getHeight() * pixel;
                double inwards = step * type.getHeight() * pixel / 2;
                double x = end.getX() - inwards * way.getX();
                double y = end.getY() + inwards * way.getY();
                places.add(around(x + away * way.getY(), y + away * way.getX(), name, type));
                places.add(around(x - away * way.getY(), y - away * way.getX(), name, type));
            }
        }
        return places;
    }

    private static Rectangle2D around(double x, double y, String word, FontMetrics type) {
        double width = type.stringWidth(word);
        return new Rectangle2D.Double(x - width / 2, y - type.getAscent() / 2.0, width, type.getAscent());
    }

    /** Where a line from a point of the diagram comes near the edge of this component. */
    private Point2D edge(Point2D from, Point2D direction, int margin) {
        Point2D start = place(from);
        double right = direction.getX();
        double down = -direction.getY();
        double across = right == 0
                ? Double.POSITIVE_INFINITY
                : ((right > 0 ? getWidth() - margin : margin) - start.getX()) / right;
        double along = down == 0
                ? Double.POSITIVE_INFINITY
                : ((down > 0 ? getHeight() - margin / 2.0 : margin / 2.0) - start.getY()) / down;
        double length = Math.max(0, Math.min(across, along));
        return new Point2D.Double(start.getX() + length * right, start.getY() + length * down);
    }

    /** The way of the ray in straight pieces, in pixels; at least a point. */
    private List<Line2D> ray() {
        List<Point2D> corners =
                new ArrayList<>(diagram.path().stream().map(this::place).toList());
        Point2D last = diagram.path().get(diagram.path().size() - 1);
        corners.add(diagram.onwards() == null ? place(last) : edge(last, diagram.onwards(), 0));
        return IntStream.range(1, corners.size())
                .<Line2D>mapToObj(i -> new Line2D.Double(corners.get(i - 1), corners.get(i)))
                .toList();
    }

    private void drawRay(Graphics2D g) {
        Path2D path = new Path2D.Double();
        ray().forEach(piece -> path.append(piece, true));
        g.setColor(UIManager.getColor("Component.accentColor"));
        g.setStroke(new BasicStroke(2.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
        g.draw(path);
        double radius = Look.pixels(DOT);
        for (Point2D event : diagram.path()) {
            Point2D centre = place(event);
            g.fill(Drawing.circle(centre.getX(), centre.getY(), radius));
        }
    }

    /** A line through the event at the lens, from edge to edge, in pixels. */
    private Line2D through(Point2D direction) {
        return through(new Point2D.Double(), direction);
    }

    /** A line through an event, from edge to edge, in pixels. */
    private Line2D through(Point2D event, Point2D direction) {
        double length = 2.0 * (getWidth() + getHeight()) / (scale() * direction.distance(0, 0));
        return new Line2D.Double(
                place(sum(event, times(direction, -length))), place(sum(event, times(direction, length))));
    }

    private static Point2D sum(Point2D first, Point2D second) {
        return new Point2D.Double(first.getX() + second.getX(), first.getY() + second.getY());
    }

    private static Point2D times(Point2D point, double factor) {
        return new Point2D.Double(factor * point.getX(), factor * point.getY());
    }
}
