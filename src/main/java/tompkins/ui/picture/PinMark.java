package tompkins.ui.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;

/** Four lines around a place of a picture, black and white, so that they are seen on any colour. */
final class PinMark {

    private PinMark() {}

    /** Paints the mark. */
    static void paint(Graphics2D g, double x, double y) {
        AffineTransform before = g.getTransform();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.translate(x, y);
        for (Color colour : new Color[] {Color.BLACK, Color.WHITE}) {
            g.setColor(colour);
            g.setStroke(new BasicStroke(colour == Color.BLACK ? 3.5f : 1.5f));
            for (int quarter = 0; quarter < 4; quarter++) {
                g.draw(new Line2D.Double(5, 0, 14, 0));
                g.rotate(Math.PI / 2);
            }
        }
        g.setTransform(before);
    }
}
