package tompkins.ui.panel;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.function.Consumer;
import javax.swing.Icon;
import javax.swing.UIManager;
import tompkins.shutter.SweepDirection;
import tompkins.ui.widget.Drawing;

/** Tiny drawings of when the shutter opens, with what opens in the accent colour. */
final class TimingIcon {

    private static final int WIDTH = 20;
    private static final int HEIGHT = 16;

    private TimingIcon() {}

    /** A time line with the part in which the shutter is open. */
    static Icon exposure() {
        return drawing(g -> {
            double middle = HEIGHT / 2.0;
            g.draw(new Line2D.Double(1, middle, WIDTH - 1, middle));
            accent(g);
            for (double end : new double[] {5, 14}) {
                g.draw(new Line2D.Double(end, 3, end, HEIGHT - 3));
            }
            g.fill(new Rectangle2D.Double(5, middle - 2, 9, 4));
        });
    }

    /** A picture, the line in it that is open, and an arrow that shows where the shutter rolls. */
    static Icon rolling(SweepDirection direction) {
        return drawing(g -> {
            g.draw(new Rectangle2D.Double(2.5, 1.5, WIDTH - 5, HEIGHT - 3));
            accent(g);
            g.translate(WIDTH / 2.0, HEIGHT / 2.0);
            g.rotate(turn(direction));
            g.fill(new Rectangle2D.Double(-5, -5.5, 10, 2.5));
            g.draw(new Line2D.Double(0, -2, 0, 4));
            Path2D head = new Path2D.Double();
            head.moveTo(-3, 1);
            head.lineTo(0, 4.5);
            head.lineTo(3, 1);
            g.draw(head);
        });
    }

    /** The drawing is one of a shutter that rolls down. */
    private static double turn(SweepDirection direction) {
        return switch (direction) {
            case DOWN -> 0;
            case LEFT -> Math.PI / 2;
            case UP -> Math.PI;
            case RIGHT -> -Math.PI / 2;
        };
    }

    private static void accent(Graphics2D g) {
        g.setColor(UIManager.getColor("Component.accentColor"));
        g.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    }

    private static Icon drawing(Consumer<Graphics2D> painter) {
        return new Drawing(WIDTH, HEIGHT, (g, component) -> {
            g.setColor(UIManager.getColor("Tompkins.note"));
            g.setStroke(new BasicStroke(1));
            painter.accept(g);
        });
    }
}
