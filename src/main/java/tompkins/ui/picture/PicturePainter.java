package tompkins.ui.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
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
        ScreenPicture shown = seen.shown();
        Rectangle bounds = seen.bounds();
        Rectangle room = seen.room();
        if (seen.showsDifference()) {
            paint(g, shown.difference(), bounds, room);
            label(g, Texts.get("compare.differenceLabel", otherName), visible(), Corner.TOP_LEFT);
            caption(g, shown.now(), visible(), Corner.BOTTOM_LEFT);
        } else if (seen.showsOtherAlone()) {
            paint(g, shown.otherImage(), bounds, room);
            label(g, otherName, visible(), Corner.TOP_LEFT);
            caption(g, shown.other(), visible(), Corner.BOTTOM_LEFT);
        } else if (seen.splits()) {
            paintSplit(g, bounds, room);
        } else {
            paint(g, shown.nowImage(), bounds, room);
            caption(g, shown.now(), visible(), Corner.BOTTOM_LEFT);
        }
        if (seen.comparison() != Comparison.NONE && shown.other() != null && shown.otherImage() == null) {
            label(g, Texts.get("compare.otherShape", otherName), visible(), Corner.TOP_LEFT);
        }
        if (seen.isBeside() && shown.otherImage() != null) {
            paintBeside(g);
        }
    }

    private Rectangle visible() {
        return seen.bounds().intersection(seen.room());
    }

    private void paintBeside(Graphics2D g) {
        Rectangle there = seen.otherBounds();
        paint(g, seen.shown().otherImage(), there, seen.otherRoom());
        Rectangle visible = there.intersection(seen.otherRoom());
        label(g, otherName, visible, Corner.TOP_LEFT);
        caption(g, seen.shown().other(), visible, Corner.BOTTOM_LEFT);
        label(g, Texts.get("compare.now"), visible(), Corner.TOP_LEFT);
    }

    private void paintSplit(Graphics2D g, Rectangle bounds, Rectangle room) {
        int x = seen.dividerX();
        Rectangle left = new Rectangle(bounds.x, bounds.y, x - bounds.x, bounds.height).intersection(room);
        Rectangle right = new Rectangle(x, bounds.y, bounds.x + bounds.width - x, bounds.height).intersection(room);
        paint(g, seen.shown().otherImage(), bounds, right);
        paint(g, seen.shown().nowImage(), bounds, left);
        Graphics2D half = (Graphics2D) g.create();
        half.clip(inUnits(right));
        label(half, otherName, right, Corner.TOP_RIGHT);
        caption(half, seen.shown().other(), right, Corner.BOTTOM_RIGHT);
        half.setClip(g.getClip());
        half.clip(inUnits(left));
        label(half, Texts.get("compare.now"), left, Corner.TOP_LEFT);
        caption(half, seen.shown().now(), left, Corner.BOTTOM_LEFT);
        half.dispose();
        Rectangle visible = inUnits(visible());
        Mark.paintDivider(g, (int) Math.round(x / scale), visible.y, visible.height);
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

    /** The visible part of the picture, in units of the canvas, without the lines that are written if there are two. */
    Rectangle free(Graphics2D g) {
        Rectangle free = inUnits(visible());
        if (seen.showsTwo()) {
            int line = PictureLabel.height(g, font);
            free.y += line;
            free.height -= captions == null ? line : 2 * line;
        }
        return free;
    }

    private void caption(Graphics2D g, Picture picture, Rectangle bounds, Corner corner) {
        String text = captions == null ? "" : captions.apply(picture.studio());
        if (!text.isEmpty()) {
            label(g, text, bounds, corner);
        }
    }

    private void label(Graphics2D g, String text, Rectangle bounds, Corner corner) {
        PictureLabel.paint(g, font, text, inUnits(bounds), corner);
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

    /** Marks a place of the photograph, in both pictures if they are beside each other. */
    void paintPin(Graphics2D g, Point2D place) {
        Rectangle bounds = seen.bounds();
        Mark.paintPin(g, x(place, bounds), y(place, bounds));
        if (seen.isBeside() && seen.shown().otherImage() != null) {
            Rectangle there = seen.otherBounds();
            Mark.paintPin(g, x(place, there), y(place, there));
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
