package tompkins.ui.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import javax.swing.Icon;
import javax.swing.UIManager;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.ArbitraryPlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.LensHologramShutter;
import tompkins.ui.widget.Drawing;

/**
 * A tiny drawing of a camera from the side, detector to the left, lens in the middle, the surface in focus to the
 * right, with the shutter in the accent colour.
 */
final class ShutterIcon {

    private static final int WIDTH = 64;
    private static final int HEIGHT = 28;
    private static final double DETECTOR = 8;
    private static final double LENS = 24;
    private static final double FOCUS = 56;
    private static final double TOP = 4;
    private static final double BOTTOM = HEIGHT - 4;
    private static final double MIDDLE = HEIGHT / 2.0;

    private static final Map<Class<?>, Consumer<Graphics2D>> DRAWINGS = Map.of(
            AperturePlaneShutter.class, g -> g.draw(line(LENS, LENS)),
            DetectorPlaneShutter.class, g -> g.draw(line(DETECTOR, DETECTOR)),
            LensHologramShutter.class, g -> g.draw(line(DETECTOR, DETECTOR)),
            FocusSurfaceShutter.class, g -> g.draw(line(FOCUS, FOCUS)),
            ArbitraryPlaneShutter.class, g -> g.draw(line(36, 46)),
            FixedPointSurfaceShutter.class,
                    g -> g.draw(new Arc2D.Double(FOCUS - 13, 2, 16, HEIGHT - 4, -75, 150, Arc2D.OPEN)));

    private final Class<?> shutter;
    private final Consumer<Graphics2D> drawing;
    private final Color ink;

    /** A drawing for a shutter model, all in one ink, or in the colours of the look if that is null. */
    static Icon of(Class<?> shutter, Color ink) {
        ShutterIcon icon = new ShutterIcon(shutter, ink);
        return new Drawing(WIDTH, HEIGHT, (g, component) -> icon.paint(g));
    }

    private ShutterIcon(Class<?> shutter, Color ink) {
        this.shutter = shutter;
        drawing = Objects.requireNonNull(DRAWINGS.get(shutter), () -> "no drawing for " + shutter);
        this.ink = ink;
    }

    private Color colour(String name) {
        return ink == null ? UIManager.getColor(name) : ink;
    }

    private static Line2D line(double bottom, double top) {
        return new Line2D.Double(bottom, BOTTOM, top, TOP);
    }

    private void paint(Graphics2D g) {
        g.setColor(colour("Tompkins.note"));
        g.setStroke(new BasicStroke(1));
        paintRays(g);
        g.draw(line(DETECTOR, DETECTOR));
        paintLens(g);
        g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {2, 2}, 0));
        g.draw(line(FOCUS, FOCUS));
        g.setColor(colour("Component.accentColor"));
        g.setStroke(new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        drawing.accept(g);
    }

    private static void paintRays(Graphics2D g) {
        Path2D rays = new Path2D.Double();
        rays.moveTo(DETECTOR, MIDDLE);
        rays.lineTo(LENS, TOP + 2);
        rays.lineTo(FOCUS, MIDDLE);
        rays.lineTo(LENS, BOTTOM - 2);
        rays.closePath();
        Color colour = g.getColor();
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 110));
        g.draw(rays);
        g.setColor(colour);
    }

    private void paintLens(Graphics2D g) {
        if (shutter == LensHologramShutter.class) {
            g.setStroke(new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {3, 1}, 0));
            g.draw(line(LENS, LENS));
            g.setStroke(new BasicStroke(1));
        } else {
            g.draw(new Ellipse2D.Double(LENS - 2.5, TOP, 5, BOTTOM - TOP));
        }
    }
}
