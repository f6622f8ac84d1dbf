package tompkins.ui.picture;

import java.awt.AlphaComposite;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;

/** What a picture is called, in white on black in one of its upper corners. */
final class Caption {

    /** Distance from the edges of the picture. */
    private static final int GAP = 12;

    /** Room around the text. */
    private static final int MARGIN = 8;

    private Caption() {}

    /** Writes a text into a corner of a picture; what there is no room for is left out at its end. */
    static void paint(Graphics2D graphics, Font font, String text, Rectangle picture, boolean atRight) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(font);
        FontMetrics metrics = g.getFontMetrics();
        String fitting = shortened(text, metrics, picture.width - 2 * (GAP + MARGIN));
        int width = metrics.stringWidth(fitting) + 2 * MARGIN;
        int left = atRight ? picture.x + picture.width - GAP - width : picture.x + GAP;
        int top = picture.y + GAP;
        g.setComposite(AlphaComposite.SrcOver.derive(0.65f));
        g.setColor(Color.BLACK);
        g.fillRoundRect(left, top, width, metrics.getHeight() + 6, 12, 12);
        g.setComposite(AlphaComposite.SrcOver);
        g.setColor(Color.WHITE);
        g.drawString(fitting, left + MARGIN, top + 3 + metrics.getAscent());
        g.dispose();
    }

    private static String shortened(String text, FontMetrics metrics, int room) {
        if (metrics.stringWidth(text) <= room) {
            return text;
        }
        int length = text.length();
        while (length > 0 && metrics.stringWidth(text.substring(0, length) + "\u2026") > room) {
            length--;
        }
        return text.substring(0, length) + "\u2026";
    }
}
