package tompkins.ui.widget;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RadialGradientPaint;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.property.NumberText;

/**
 * A small sphere with an arrow for a direction, seen from behind and above the camera: x to the right, y up, z away.
 * The arrow can be dragged; arrow keys turn it by 5 degrees. Past the rim, or with Shift, it points towards the viewer.
 */
@SuppressWarnings("serial") // never written to a stream
public final class DirectionSphere extends JPanel {

    /** In sizes of the type. */
    private static final double SIZE = 6.4;

    private static final double STEP = Math.toRadians(5);

    /** The view: turned to the right and down a little, so that z does not hide behind the origin. */
    private static final double TURN = Math.toRadians(38);

    private static final double TILT = Math.toRadians(22);

    private final transient BiConsumer<Vector3dc, Object> turned;
    private final transient Object gesture = new Object();
    private transient Vector3dc direction = new Vector3d(0, 0, 1);

    /** A sphere that tells of new directions with the gesture that they belong to, and of the end of a gesture. */
    public DirectionSphere(BiConsumer<Vector3dc, Object> turned, Consumer<Object> released) {
        this.turned = turned;
        setOpaque(false);
        Naming.name(this, Texts.get("direction.name"), Texts.get("direction.tip"));
        setFocusable(true);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                requestFocusInWindow();
                mouseDragged(event);
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                tell(at(event.getX(), event.getY(), event.isShiftDown()));
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                released.accept(gesture);
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                repaint();
            }

            @Override
            public void focusLost(FocusEvent event) {
                released.accept(gesture);
                repaint();
            }
        });
        key("LEFT", -STEP, 0);
        key("RIGHT", STEP, 0);
        key("UP", 0, STEP);
        key("DOWN", 0, -STEP);
    }

    private void key(String key, double longitude, double latitude) {
        Keys.bindFocused(this, KeyStroke.getKeyStroke(key), () -> {
            double up = Math.asin(Math.max(-1, Math.min(1, direction.y()))) + latitude;
            double level = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, up));
            double around = Math.atan2(direction.x(), direction.z()) + longitude;
            tell(new Vector3d(Math.cos(level) * Math.sin(around), Math.sin(level), Math.cos(level) * Math.cos(around)));
        });
    }

    private void tell(Vector3d exact) {
        Vector3d rounded = new Vector3d(
                NumberText.rounded(Math.rint(exact.x * 1e3) / 1e3, 6),
                NumberText.rounded(Math.rint(exact.y * 1e3) / 1e3, 6),
                NumberText.rounded(Math.rint(exact.z * 1e3) / 1e3, 6));
        turned.accept(rounded, gesture);
    }

    /** Shows a direction of any length but 0. */
    public void show(Vector3dc other) {
        direction = Vectors.unit(other);
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.pixels(SIZE), Look.pixels(SIZE));
    }

    private double radius() {
        return Math.min(getWidth(), getHeight()) / 2.0 - 4;
    }

    /** From scene axes to view axes: x right, y up, z away. */
    private static Vector3d toView(Vector3dc vector) {
        return new Vector3d(vector).rotateY(TURN).rotateX(-TILT);
    }

    private static Vector3d fromView(Vector3dc vector) {
        return new Vector3d(vector).rotateX(TILT).rotateY(-TURN);
    }

    /** The direction under a point: on the far half of the sphere, on the near half with {@code near}. */
    Vector3d at(int x, int y, boolean near) {
        double across = (x - getWidth() / 2.0) / radius();
        double up = (getHeight() / 2.0 - y) / radius();
        double off = Math.hypot(across, up);
        boolean outside = off > 1;
        if (outside) {
            // past the rim the arrow goes over to the near half
            double back = Math.max(0, 2 - off) / off;
            across *= back;
            up *= back;
        }
        double depth = Math.sqrt(Math.max(0, 1 - across * across - up * up));
        return fromView(new Vector3d(across, up, outside != near ? -depth : depth));
    }

    /** The point of this component at which a direction ends. */
    Point2D pointOf(Vector3dc unit) {
        Vector3d view = toView(unit);
        return new Point2D.Double(getWidth() / 2.0 + view.x * radius(), getHeight() / 2.0 - view.y * radius());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        Drawing.smooth(g);
        paintBall(g);
        paintAxis(g, new Vector3d(1, 0, 0), "x");
        paintAxis(g, new Vector3d(0, 1, 0), "y");
        paintAxis(g, new Vector3d(0, 0, 1), "z");
        paintArrow(g);
        g.dispose();
    }

    private void paintBall(Graphics2D g) {
        double r = radius();
        double x = getWidth() / 2.0;
        double y = getHeight() / 2.0;
        Color light = UIManager.getColor("Tompkins.sphereLight");
        Color dark = UIManager.getColor("Tompkins.sphereDark");
        g.setPaint(new RadialGradientPaint(
                new Point2D.Double(x - r / 3, y - r / 3), (float) (1.5 * r), new float[] {0, 1}, new Color[] {
                    light, dark
                }));
        g.fill(Drawing.circle(x, y, r));
        g.setColor(UIManager.getColor(isFocusOwner() ? "Component.focusColor" : "Tompkins.line"));
        g.setStroke(new BasicStroke(isFocusOwner() ? 2.5f : 1));
        g.draw(Drawing.circle(x, y, r));
        g.setStroke(new BasicStroke(1));
        g.setColor(UIManager.getColor("Tompkins.line"));
        Path2D equator = new Path2D.Double();
        for (int degrees = 0; degrees <= 360; degrees += 10) {
            double angle = Math.toRadians(degrees);
            Point2D point = pointOf(new Vector3d(Math.sin(angle), 0, Math.cos(angle)));
            if (degrees == 0) {
                equator.moveTo(point.getX(), point.getY());
            } else {
                equator.lineTo(point.getX(), point.getY());
            }
        }
        g.draw(equator);
    }

    private void paintAxis(Graphics2D g, Vector3dc axis, String name) {
        Point2D end = pointOf(axis);
        double x = getWidth() / 2.0;
        double y = getHeight() / 2.0;
        g.setColor(UIManager.getColor("Tompkins.note"));
        g.draw(new Line2D.Double(x, y, end.getX(), end.getY()));
        g.setFont(UIManager.getFont("small.font"));
        g.drawString(name, (float) (x + (end.getX() - x) * 0.82 + 3), (float) (y + (end.getY() - y) * 0.82 + 3));
    }

    private void paintArrow(Graphics2D g) {
        Point2D end = pointOf(direction);
        double x = getWidth() / 2.0;
        double y = getHeight() / 2.0;
        double length = end.distance(x, y);
        boolean away = toView(direction).z >= 0;
        g.setColor(UIManager.getColor("Component.accentColor"));
        g.setStroke(new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        AffineTransform before = g.getTransform();
        g.translate(x, y);
        g.rotate(Math.atan2(end.getY() - y, end.getX() - x));
        g.draw(new Line2D.Double(0, 0, Math.max(0, length - 4), 0));
        Path2D head = new Path2D.Double();
        head.moveTo(length + 2, 0);
        head.lineTo(length - 9, -6);
        head.lineTo(length - 9, 6);
        head.closePath();
        // towards the viewer: a full head; away: a hollow one
        if (away) {
            g.setColor(UIManager.getColor("Tompkins.sphereLight"));
            g.fill(head);
            g.setColor(UIManager.getColor("Component.accentColor"));
            g.setStroke(new BasicStroke(1.8f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.draw(head);
        } else {
            g.fill(head);
        }
        g.setTransform(before);
    }
}
