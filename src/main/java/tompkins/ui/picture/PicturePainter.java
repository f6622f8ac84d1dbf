package tompkins.ui.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import tompkins.image.PictureLabel;
import tompkins.image.PictureLabel.Corner;
import tompkins.studio.Studio;
import tompkins.ui.widget.Texts;

/**
 * Paints the pictures of an arrangement in pixels of the screen, with the writing and the marks on them.
 *
 * @param seen where each picture is
 * @param otherName what to call the other picture
 * @param captions what to write into a picture of a studio; null if nothing
 * @param font the font of what is written
 * @param scale pixels of the screen for each unit of the canvas
 */
record PicturePainter(
        PictureArrangement seen, String otherName, Function<Studio, String> captions, Font font, double scale) {

    private static final double ALMOST_NOTHING = 1e-9;

    /** Paints on an empty canvas. */
    void paint(Graphics2D g) {
        Font titles = common(g, this::title);
        Font below = common(g, this::caption);
        for (PictureArrangement.Pane pane : seen.panes()) {
            paint(g, pane.image(), pane.bounds(), pane.part());
            Graphics2D clipped = (Graphics2D) g.create();
            clipped.clip(inUnits(pane.visible()));
            boolean right = seen.splits() && pane.isOther();
            label(clipped, titles, title(pane), pane.visible(), right ? Corner.TOP_RIGHT : Corner.TOP_LEFT);
            label(clipped, below, caption(pane), pane.visible(), right ? Corner.BOTTOM_RIGHT : Corner.BOTTOM_LEFT);
            clipped.dispose();
        }
        if (seen.splits()) {
            Rectangle visible = inUnits(visible());
            Mark.paintDivider(g, (int) Math.round(seen.dividerX() / scale), visible.y, visible.height);
        }
        if (seen.comparison() != Comparison.NONE
                && seen.shown().other() != null
                && seen.shown().otherImage() == null) {
            label(g, font, Texts.get("compare.otherShape", otherName), visible(), Corner.TOP_LEFT);
        }
    }

    /** What a picture is called; empty if it is shown alone. */
    private String title(PictureArrangement.Pane pane) {
        if (seen.showsDifference()) {
            return Texts.get("compare.differenceLabel", otherName);
        }
        return pane.isOther() ? otherName : seen.showsTwo() ? seen.shown().nameOfNow() : "";
    }

    private Rectangle visible() {
        return seen.bounds().intersection(seen.room());
    }

    /** Paints an image, clipped to a part of the canvas. */
    private void paint(Graphics2D graphics, BufferedImage image, Rectangle bounds, Rectangle part) {
        Graphics2D g = (Graphics2D) graphics.create();
        toPixels(g);
        g.clip(part);
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                seen.zoom() == null
                        ? RenderingHints.VALUE_INTERPOLATION_BILINEAR
                        : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        g.drawImage(image, bounds.x, bounds.y, bounds.width, bounds.height, null);
        g.dispose();
    }

    /** From here on, a unit is exactly a pixel of the screen; otherwise a picture would not stay sharp. */
    private void toPixels(Graphics2D g) {
        g.scale(1 / scale, 1 / scale);
        AffineTransform pixels = g.getTransform();
        if (Math.abs(pixels.getScaleX() - 1) < ALMOST_NOTHING) {
            g.setTransform(AffineTransform.getTranslateInstance(
                    Math.rint(pixels.getTranslateX()), Math.rint(pixels.getTranslateY())));
        }
    }

    /** The visible part of the picture, in units of the canvas, between titles and captions. */
    Rectangle free(Graphics2D g) {
        Rectangle free = inUnits(visible());
        int line = PictureLabel.height(g, font);
        if (seen.showsTwo()) {
            free.y += line;
            free.height -= line;
        }
        if (seen.panes().stream().anyMatch(pane -> !caption(pane).isEmpty())) {
            free.height -= line;
        }
        return free;
    }

    private String caption(PictureArrangement.Pane pane) {
        return captions == null ? "" : captions.apply(pane.picture().studio());
    }

    /** One font for what is written at the same edge of both pictures. */
    private Font common(Graphics2D g, Function<PictureArrangement.Pane, String> text) {
        Map<String, Integer> widths = new HashMap<>();
        seen.panes().forEach(pane -> widths.merge(text.apply(pane), inUnits(pane.visible()).width, Math::min));
        return PictureLabel.common(g, font, widths);
    }

    private void label(Graphics2D g, Font size, String text, Rectangle bounds, Corner corner) {
        if (!text.isEmpty()) {
            PictureLabel.paint(g, size, text, inUnits(bounds), corner);
        }
    }

    private Rectangle inUnits(Rectangle pixels) {
        return inUnits(pixels, scale);
    }

    /** A part of the canvas in its own units. */
    static Rectangle inUnits(Rectangle pixels, double scale) {
        int left = (int) Math.round(pixels.x / scale);
        int top = (int) Math.round(pixels.y / scale);
        return new Rectangle(
                left,
                top,
                (int) Math.round((pixels.x + pixels.width) / scale) - left,
                (int) Math.round((pixels.y + pixels.height) / scale) - top);
    }

    /** Marks a place of the photograph in each picture that is seen. */
    void paintPin(Graphics2D graphics, Point2D place) {
        for (PictureArrangement.Pane pane : seen.panes()) {
            Graphics2D g = (Graphics2D) graphics.create();
            g.clip(inUnits(pane.part()));
            Mark.paintPin(g, x(place, pane.bounds()), y(place, pane.bounds()));
            g.dispose();
        }
    }

    /** Marks the place of the photograph at which the keys point. */
    void paintRing(Graphics2D g, Point2D place) {
        Mark.paintRing(g, x(place, seen.bounds()), y(place, seen.bounds()));
    }

    private double x(Point2D place, Rectangle bounds) {
        return (bounds.x + place.getX() * bounds.width / seen.shown().now().ownWidth()) / scale;
    }

    private double y(Point2D place, Rectangle bounds) {
        return (bounds.y + place.getY() * bounds.height / seen.shown().now().ownHeight()) / scale;
    }
}
