package tompkins.ui.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import tompkins.ui.widget.Drawing;

/** Marks on a picture, white within black, so that they are visible on any colour. */
public final class Mark {

    private static final double RADIUS = 7;
    private static final double INNER = 5;
    private static final double OUTER = 14;

    /** How far the rays of a lamp reach, how many there are, and their colour. */
    private static final double LAMP = 11;

    private static final int RAYS = 8;
    private static final Color LIGHT = new Color(255, 224, 96);

    /** How wide the black edge of a text is, and how often the text is drawn for it. */
    private static final double EDGE = 1.5;

    private static final int EDGES = 8;

    private Mark() {}

    /** Four lines around a pinned place. */
    static void paintPin(Graphics2D g, double x, double y) {
        Path2D lines = new Path2D.Double();
        for (int side = -1; side <= 1; side += 2) {
            lines.append(new Line2D.Double(x + INNER * side, y, x + OUTER * side, y), false);
            lines.append(new Line2D.Double(x, y + INNER * side, x, y + OUTER * side), false);
        }
        paint(g, lines);
    }

    /** A small sun where the light of a lamp comes from. */
    public static void paintLamp(Graphics2D g, double x, double y) {
        Path2D lines = new Path2D.Double(Drawing.circle(x, y, INNER));
        for (int ray = 0; ray < RAYS; ray++) {
            double right = Math.cos(2 * Math.PI * ray / RAYS);
            double down = Math.sin(2 * Math.PI * ray / RAYS);
            lines.append(
                    new Line2D.Double(x + RADIUS * right, y + RADIUS * down, x + LAMP * right, y + LAMP * down), false);
        }
        paintLines(g, lines, LIGHT, false);
    }

    /** A ring around the place at which the keys point. */
    static void paintRing(Graphics2D g, double x, double y) {
        paint(g, Drawing.circle(x, y, RADIUS));
    }

    /** A line from top to bottom with a handle, below the middle, where it would lie over what is ahead. */
    static void paintDivider(Graphics2D g, int x, int y, int height) {
        g.setColor(Color.BLACK);
        g.fillRect(x - 2, y, 4, height);
        g.setColor(Color.WHITE);
        g.fillRect(x - 1, y, 2, height);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        int middle = y + height * 2 / 3;
        g.fillRoundRect(x - 5, middle - 18, 10, 36, 10, 10);
        g.setColor(Color.DARK_GRAY);
        g.drawRoundRect(x - 5, middle - 18, 10, 36, 10, 10);
    }

    /** Coloured lines along a shape; fine ones hide less of the picture. */
    public static void paintLines(Graphics2D g, Shape shape, Color colour, boolean fine) {
        Drawing.smooth(g);
        g.setColor(new Color(0, 0, 0, fine ? 110 : 190));
        g.setStroke(new BasicStroke(fine ? 2.4f : 3.4f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(shape);
        g.setColor(colour);
        g.setStroke(new BasicStroke(fine ? 1 : 1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(shape);
    }

    /** Lines along a shape. */
    public static void paint(Graphics2D g, Shape shape) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Color.BLACK);
        g.setStroke(new BasicStroke(3.5f));
        g.draw(shape);
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(shape);
    }

    /** A text that begins at a point of its base line. */
    public static void paintText(Graphics2D g, Font font, String text, double x, double y) {
        paintText(g, font, text, x, y, Color.WHITE);
    }

    /** A coloured text that begins at a point of its base line. */
    public static void paintText(Graphics2D g, Font font, String text, double x, double y, Color colour) {
        if (text.isEmpty()) {
            return;
        }
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(font);
        g.setColor(Color.BLACK);
        // glyphs are kept by the display; the lines around their outlines took longer than all else that is painted
        for (int side = 0; side < EDGES; side++) {
            double angle = 2 * Math.PI * side / EDGES;
            g.drawString(text, (float) (x + EDGE * Math.cos(angle)), (float) (y + EDGE * Math.sin(angle)));
        }
        g.setColor(colour);
        g.drawString(text, (float) x, (float) y);
    }
}
