package tompkins.image;

import java.awt.AlphaComposite;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/** A line of text in white on black in a corner of a picture. */
public final class PictureLabel {

    /** Where in a picture a label stands. */
    public enum Corner {
        TOP_LEFT,
        TOP_MIDDLE,
        TOP_RIGHT,
        BOTTOM_LEFT,
        BOTTOM_RIGHT
    }

    /** Distance from the edges of the picture, room beside the text, and room above and below it, in sizes of type. */
    private static final double GAP = 0.9;

    private static final double MARGIN = 0.6;
    private static final double HALF_MARGIN = 0.25;

    /** Size of the type as a share of the height of a saved picture; it is never too small to be read. */
    private static final double HEIGHT_SHARE = 1 / 28.0;

    private static final int SMALLEST = 9;

    /** Much smaller than usual is what is below this share of the usual size, or below this size. */
    private static final double READABLE = 0.6;

    private static final int LEGIBLE = 11;

    private static final Pattern CLAUSES = Pattern.compile("(?<=[,.]) ");

    private static final String BETWEEN_PARTS = " \u00b7 ";

    private PictureLabel() {}

    /** Writes a text into the lower left corner of a picture that leaves the program, in its own size. */
    public static void paint(BufferedImage picture, String text) {
        int size = (int) Math.max(SMALLEST, Math.round(HEIGHT_SHARE * picture.getHeight()));
        Graphics2D graphics = picture.createGraphics();
        Rectangle whole = new Rectangle(picture.getWidth(), picture.getHeight());
        paint(graphics, new Font(Font.SANS_SERIF, Font.BOLD, size), text, whole, Corner.BOTTOM_LEFT);
        graphics.dispose();
    }

    /**
     * Writes a text into a corner of a picture: in smaller type if there is no room for it, and without its end if that
     * is not enough.
     */
    public static void paint(Graphics2D graphics, Font usual, String text, Rectangle picture, Corner corner) {
        Font font = fitting(graphics, usual, text, picture.width);
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(font);
        FontMetrics metrics = g.getFontMetrics();
        int gap = sizes(GAP, font);
        int margin = sizes(MARGIN, font);
        int halfMargin = sizes(HALF_MARGIN, font);
        String fitting = shortened(text, metrics, picture.width - 2 * (gap + margin));
        int width = metrics.stringWidth(fitting) + 2 * margin;
        int height = metrics.getHeight() + 2 * halfMargin;
        boolean atRight = corner == Corner.TOP_RIGHT || corner == Corner.BOTTOM_RIGHT;
        boolean atTop = corner == Corner.TOP_LEFT || corner == Corner.TOP_MIDDLE || corner == Corner.TOP_RIGHT;
        int left = atRight
                ? picture.x + picture.width - gap - width
                : corner == Corner.TOP_MIDDLE ? picture.x + (picture.width - width) / 2 : picture.x + gap;
        int top = atTop ? picture.y + gap : picture.y + picture.height - gap - height;
        g.setComposite(AlphaComposite.SrcOver.derive(0.65f));
        g.setColor(Color.BLACK);
        g.fillRoundRect(left, top, width, height, gap, gap);
        g.setComposite(AlphaComposite.SrcOver);
        g.setColor(Color.WHITE);
        g.drawString(fitting, left + margin, top + halfMargin + metrics.getAscent());
        g.dispose();
    }

    /**
     * Writes parts of a text at the top, in the middle: beside each other where they have room, or one below the other.
     * What would become much smaller in one line is written clause by clause.
     *
     * @return the room that is left below them
     */
    public static Rectangle paintParts(Graphics2D graphics, Font usual, List<String> parts, Rectangle picture) {
        Rectangle room = picture;
        String line = "";
        for (String part : parts) {
            String longer = line.isEmpty() ? part : line + BETWEEN_PARTS + part;
            if (line.isEmpty() || fits(graphics, usual, longer, room.width)) {
                line = longer;
            } else {
                room = paintLine(graphics, usual, line, room);
                line = part;
            }
        }
        return paintLine(graphics, usual, line, room);
    }

    private static Rectangle paintLine(Graphics2D graphics, Font usual, String line, Rectangle picture) {
        Rectangle room = picture;
        int height = height(graphics, usual);
        for (String piece : pieces(graphics, usual, line, picture.width)) {
            paint(graphics, usual, piece, room, Corner.TOP_MIDDLE);
            room = new Rectangle(room.x, room.y + height, room.width, room.height - height);
        }
        return room;
    }

    /** A line as it is, or its clauses, as many together as fit. */
    private static List<String> pieces(Graphics2D graphics, Font usual, String line, int width) {
        if (fits(graphics, readable(usual), line, width)) {
            return List.of(line);
        }
        List<String> pieces = new ArrayList<>();
        for (String clause : CLAUSES.split(line)) {
            int last = pieces.size() - 1;
            String longer = last < 0 ? clause : pieces.get(last) + " " + clause;
            if (last >= 0 && fits(graphics, usual, longer, width)) {
                pieces.set(last, longer);
            } else {
                pieces.add(clause);
            }
        }
        return pieces;
    }

    /** A font in which all texts fit into their widths; much smaller than the usual one it does not become. */
    public static Font common(Graphics2D graphics, Font usual, Map<String, Integer> widths) {
        Font common = usual;
        for (Map.Entry<String, Integer> text : widths.entrySet()) {
            common = fitting(graphics, common, text.getKey(), text.getValue());
        }
        Font least = readable(usual);
        return common.getSize2D() < least.getSize2D() ? least : common;
    }

    private static Font readable(Font usual) {
        return usual.deriveFont((float) Math.min(usual.getSize2D(), Math.max(LEGIBLE, READABLE * usual.getSize2D())));
    }

    /** How much of a picture labels at one of its edges take, with the gap between them and the edge. */
    public static int height(Graphics2D graphics, Font font) {
        return sizes(GAP, font) + graphics.getFontMetrics(font).getHeight() + 2 * sizes(HALF_MARGIN, font);
    }

    private static int sizes(double share, Font font) {
        return (int) Math.round(share * font.getSize2D());
    }

    /** The usual font, or a smaller one if the text needs it and can still be read. */
    private static Font fitting(Graphics2D graphics, Font usual, String text, int width) {
        Font font = usual;
        while (font.getSize2D() > SMALLEST && !fits(graphics, font, text, width)) {
            font = font.deriveFont(Math.max(SMALLEST, font.getSize2D() - 1));
        }
        return font;
    }

    private static boolean fits(Graphics2D graphics, Font font, String text, int width) {
        return graphics.getFontMetrics(font).stringWidth(text) <= width - 2 * (sizes(GAP, font) + sizes(MARGIN, font));
    }

    /** A text as far as it has room: without its last parts, or else without the end of a part. */
    public static String shortened(String text, FontMetrics metrics, int room) {
        String fitting = text;
        for (int end = text.length(); end > 0 && metrics.stringWidth(fitting) > room; ) {
            int part = Math.max(text.lastIndexOf("; ", end - 1), text.lastIndexOf(BETWEEN_PARTS, end - 1));
            int word = text.lastIndexOf(' ', end - 1);
            end = part > 0 ? part : word > 0 ? word : end - 1;
            fitting = text.substring(0, end).stripTrailing() + (part > 0 ? "" : "\u2026");
        }
        return fitting;
    }
}
