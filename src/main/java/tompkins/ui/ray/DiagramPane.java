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
import java.util.List;
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

/** Draws a space-time diagram, a unit of x as long as one of time. */
@SuppressWarnings("serial") // never written to a stream
final class DiagramPane extends JPanel {

    /** The most between two numbers of an axis, in sizes of the type. */
    private static final double STEP = 4.6;

    private static final double DOT = 0.28;

    /** How far inwards from its end the name of an axis may be, in halves of the height of the type. */
    private static final int STEPS_INWARDS = 8;

    private static final float[] DASHES = {3, 4};

    /** A word and its place in pixels, from the top of its letters to the line they stand on. */
    record Word(String text, Rectangle2D place) {}

    private final double size;
    private transient SpaceTimeDiagram diagram;

    /** Empty at first; its width and height are given in sizes of the type. */
    DiagramPane(double size) {
        this.size = size;
        Naming.name(this, Texts.get("ray.diagram"), "");
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.pixels(size), Look.pixels(size));
    }

    /** Shows a diagram, which a text explains; null for none. */
    void show(SpaceTimeDiagram other, String text) {
        diagram = other;
        setVisible(other != null && Double.isFinite(other.area().getWidth()));
        Naming.name(this, getName(), text);
        repaint();
    }

    /** Pixels for a unit of length, or of time. */
    private double scale() {
        Rectangle2D area = diagram.area();
        return Math.min(getWidth() / area.getWidth(), getHeight() / area.getHeight());
    }

    /** The place in this component of a point of the diagram. */
    private Point2D place(Point2D point) {
        Rectangle2D area = diagram.area();
        return new Point2D.Double(
                scale() * point.getX() - getWidth() * area.getX() / area.getWidth(),
                getHeight() * area.getMaxY() / area.getHeight() - scale() * point.getY());
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
                .forEach(word -> g.drawString(word.text, (float) word.place.getX(), (float) word.place.getMaxY()));
        int gap = g.getFontMetrics().getDescent();
        for (boolean upright : new boolean[] {true, false}) {
            for (double tick : ticks(upright)) {
                Point2D at = place(onAxis(tick, upright));
                double aside = upright ? gap : 0;
                double up = upright ? 0 : gap;
                g.draw(new Line2D.Double(at.getX() - aside, at.getY() - up, at.getX() + aside, at.getY() + up));
            }
        }
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
        return diagram.lightThrough().stream()
                .flatMap(event -> diagram.light().stream().map(direction -> through(event, direction)))
                .toList();
    }

    private List<Line2D> otherAxes() {
        return diagram.otherTime() == null
                ? diagram.simultaneous().stream()
                        .<Line2D>map(line -> new Line2D.Double(place(line.getP1()), place(line.getP2())))
                        .toList()
                : List.of(through(diagram.otherTime()), through(diagram.otherSpace()));
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
     * The notes, the numbers on the upright axes for which there is room, and the names of all axes near their ends;
     * those of the camera have primes.
     */
    List<Word> words(FontMetrics type) {
        boolean ofScene = diagram.frame() == Frame.SCENE;
        String own = ofScene ? "" : SpaceTimeDiagram.PRIME;
        String other = ofScene ? SpaceTimeDiagram.PRIME : "";
        LabelPlacer places = new LabelPlacer(new Rectangle(1, 1, getWidth() - 2, getHeight() - 2), lines());
        List<Word> words = new ArrayList<>();
        for (SpaceTimeDiagram.Note note : diagram.notes()) {
            words.add(new Word(note.text(), places.take(beside(note.event(), note.text(), type))));
        }
        for (boolean upright : new boolean[] {true, false}) {
            for (double tick : ticks(upright)) {
                String number = Numbers.brief(tick, 3);
                List<Rectangle2D> beside = beside(onAxis(tick, upright), number, type);
                // the first two are beside a point, the others above and below it
                places.takeFree(upright ? beside.subList(0, 2) : beside.subList(2, 4))
                        .ifPresent(place -> words.add(new Word(number, place)));
            }
        }
        BiConsumer<String, Point2D> name =
                (text, direction) -> words.add(new Word(text, places.take(besideAxis(text, direction, type))));
        name.accept("t" + own, new Point2D.Double(0, 1));
        name.accept("x" + own, new Point2D.Double(1, 0));
        if (diagram.otherTime() != null && diagram.otherTime().getX() != 0) {
            // there is more room below
            name.accept("t" + other, times(diagram.otherTime(), -1));
            name.accept("x" + other, diagram.otherSpace());
        }
        return words;
    }

    private static Point2D onAxis(double tick, boolean upright) {
        return new Point2D.Double(upright ? 0 : tick, upright ? tick : 0);
    }

    /** The marks on an axis but for that at the origin. */
    private List<Double> ticks(boolean upright) {
        Rectangle2D area = diagram.area();
        double step = Numbers.niceFloor(STEP * getFont().getSize2D() / scale());
        int first = (int) Math.ceil((upright ? area.getMinY() : area.getMinX()) / step);
        int last = (int) Math.floor((upright ? area.getMaxY() : area.getMaxX()) / step);
        return IntStream.rangeClosed(first, last)
                .filter(i -> i != 0)
                .mapToObj(i -> i * step)
                // a note says it already
                .filter(tick -> diagram.notes().stream()
                        .noneMatch(note -> note.event().distance(onAxis(tick, upright)) < step / 2))
                .toList();
    }

    /** To the left of an event, to the right, below and above it. */
    private List<Rectangle2D> beside(Point2D event, String word, FontMetrics type) {
        Point2D at = place(event);
        double aside = 2 * type.getDescent() + type.stringWidth(word) / 2.0;
        double below = 2 * type.getDescent() + type.getAscent() / 2.0;
        return List.of(
                around(at.getX() - aside, at.getY(), word, type),
                around(at.getX() + aside, at.getY(), word, type),
                around(at.getX(), at.getY() + below, word, type),
                around(at.getX(), at.getY() - below, word, type));
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
        List<Point2D> events = diagram.notes().isEmpty()
                ? diagram.path()
                : diagram.notes().stream().map(SpaceTimeDiagram.Note::event).toList();
        for (Point2D event : events) {
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
