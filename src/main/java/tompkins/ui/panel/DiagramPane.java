package tompkins.ui.panel;

import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import javax.swing.JPanel;
import javax.swing.UIManager;
import tompkins.trace.Frame;
import tompkins.ui.picture.SpaceTimeDiagram;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

/** Draws the space-time diagram of a ray: the event at the lens in the middle near the top, light at 45 degrees. */
@SuppressWarnings("serial") // never written to a stream
final class DiagramPane extends JPanel {

    private static final double HEIGHT = 12.5;

    /** What is seen of the time after the ray reached the lens, in parts of what is seen of the time before. */
    private static final double AFTER = 0.22;

    /** Room around the events of the ray, as a factor. */
    private static final double ROOM = 1.12;

    private static final double DOT = 0.28;
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
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setFont(UIManager.getFont("small.font"));
        g.setColor(UIManager.getColor("TextField.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setColor(UIManager.getColor("Tompkins.line"));
        g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
        drawThrough(g, new Point2D.Double(1, 0));
        drawThrough(g, new Point2D.Double(0, 1));
        g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, DASHES, 0));
        drawThrough(g, new Point2D.Double(1, 1));
        drawThrough(g, new Point2D.Double(1, -1));
        g.setStroke(new BasicStroke(1.4f));
        g.setColor(UIManager.getColor("Tompkins.note"));
        drawThrough(g, diagram.otherTime());
        drawThrough(g, diagram.otherSpace());
        g.setStroke(new BasicStroke(1));
        nameAxes(g);
        drawRay(g);
        g.dispose();
    }

    /**
     * The numbers of the upright axis of time, and the names of all axes at their ends: those of the camera have
     * primes.
     */
    private void nameAxes(Graphics2D g) {
        boolean ofScene = diagram.frame() == Frame.SCENE;
        String own = ofScene ? "" : PRIME;
        String other = ofScene ? PRIME : "";
        name(g, "t" + own, new Point2D.Double(0, 1));
        name(g, "x" + own, new Point2D.Double(1, 0));
        if (diagram.otherTime().getX() != 0) {
            name(g, "t" + other, times(diagram.otherTime(), -1));
            name(g, "x" + other, diagram.otherSpace());
        }
        double step = step();
        int gap = g.getFontMetrics().getDescent();
        for (int i = 1; step > 0 && i * step <= diagram.reach(); i++) {
            Point2D tick = place(new Point2D.Double(0, -i * step));
            g.draw(new Line2D.Double(tick.getX() - gap, tick.getY(), tick.getX() + gap, tick.getY()));
            g.drawString(Numbers.brief(-i * step, 3), (float) tick.getX() + 2 * gap, (float) tick.getY() + gap);
        }
    }

    /** The largest of 1, 2, 5, 10, ... that is at most half of the reach; 0 if that is 0. */
    private double step() {
        double half = diagram.reach() / 2;
        double power = Math.pow(10, Math.floor(Math.log10(half)));
        return (half >= 5 * power ? 5 : half >= 2 * power ? 2 : 1) * power;
    }

    /**
     * Writes a name to the right of the end of an axis, as it is seen from the event at the lens; to the left of one
     * that runs down to the right, for there is the edge.
     */
    private void name(Graphics2D g, String name, Point2D direction) {
        FontMetrics type = g.getFontMetrics();
        Point2D end = edge(new Point2D.Double(), direction, type.getHeight());
        boolean falls = direction.getX() > 0 && direction.getY() < 0;
        double away = (falls ? -0.8 : 0.8) * type.getHeight() / direction.distance(0, 0);
        double x = end.getX() + away * direction.getY() - type.stringWidth(name) / 2.0;
        double y = end.getY() + away * direction.getX() + type.getAscent() / 2.0;
        g.drawString(name, (float) x, (float) y);
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
                : ((down > 0 ? getHeight() - margin / 2.0 : margin) - start.getY()) / down;
        double length = Math.max(0, Math.min(across, along));
        return new Point2D.Double(start.getX() + length * right, start.getY() + length * down);
    }

    private void drawRay(Graphics2D g) {
        Path2D ray = new Path2D.Double();
        Point2D lens = place(diagram.path().get(0));
        ray.moveTo(lens.getX(), lens.getY());
        diagram.path().stream().map(this::place).forEach(point -> ray.lineTo(point.getX(), point.getY()));
        if (diagram.onwards() != null) {
            Point2D last = diagram.path().get(diagram.path().size() - 1);
            Point2D end = edge(last, diagram.onwards(), 0);
            ray.lineTo(end.getX(), end.getY());
        }
        g.setColor(UIManager.getColor("Component.accentColor"));
        g.setStroke(new BasicStroke(2.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
        g.draw(ray);
        double radius = Look.pixels(DOT);
        for (Point2D event : diagram.path()) {
            Point2D centre = place(event);
            g.fill(new Ellipse2D.Double(centre.getX() - radius, centre.getY() - radius, 2 * radius, 2 * radius));
        }
    }

    /** Draws a line through the event at the lens, from edge to edge. */
    private void drawThrough(Graphics2D g, Point2D direction) {
        double length = 2.0 * (getWidth() + getHeight()) / (scale() * direction.distance(0, 0));
        g.draw(new Line2D.Double(place(times(direction, -length)), place(times(direction, length))));
    }

    private static Point2D times(Point2D point, double factor) {
        return new Point2D.Double(factor * point.getX(), factor * point.getY());
    }
}
