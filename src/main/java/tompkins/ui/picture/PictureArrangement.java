package tompkins.ui.picture;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.List;
import tompkins.camera.StereoLayout;
import tompkins.camera.ThinLensCamera;

/**
 * Where on the canvas each picture is, in pixels of the screen.
 *
 * @param shown the pictures
 * @param comparison how the two are shown
 * @param otherAlone whether the other one is shown alone, if there is one
 * @param divider where the two are split, from 0 at the left edge of the picture to 1
 * @param zoom how the picture is enlarged; null if it fits into its room
 * @param canvas the size of the canvas
 * @param gap the distance between two whole pictures
 */
record PictureArrangement(
        ScreenPicture shown,
        Comparison comparison,
        boolean otherAlone,
        double divider,
        Zoom zoom,
        Dimension canvas,
        int gap) {

    /** Where the picture lies on the canvas; larger than its room if it is enlarged. */
    Rectangle bounds() {
        Picture picture = shown.now();
        Dimension room = room().getSize();
        if (picture == null) {
            return room();
        }
        if (zoom != null) {
            return zoom.place(picture.ownWidth(), picture.ownHeight(), room);
        }
        Dimension size = fitted();
        return new Rectangle((room.width - size.width) / 2, (room.height - size.height) / 2, size.width, size.height);
    }

    /** Where the other picture lies, of the same size. */
    Rectangle otherBounds() {
        Rectangle bounds = bounds();
        Rectangle room = otherRoom();
        bounds.translate(room.x, room.y);
        return bounds;
    }

    /** What is seen at a point of the canvas; null if that is no picture. */
    Pane paneAt(Point point) {
        return panes().stream()
                .filter(pane -> pane.picture != null && pane.visible().contains(point))
                .findFirst()
                .orElse(null);
    }

    /** Whether there is room for two side by side. */
    boolean isBeside() {
        return comparison == Comparison.BESIDE && !otherAlone;
    }

    /**
     * A picture on the canvas.
     *
     * @param picture the picture
     * @param image what is seen of it
     * @param isOther whether it is the one with which the picture is compared
     * @param bounds where it lies
     * @param part the part of the canvas in which it is seen
     */
    record Pane(Picture picture, BufferedImage image, boolean isOther, Rectangle bounds, Rectangle part) {

        /** The part of it that is seen. */
        Rectangle visible() {
            return bounds.intersection(part);
        }
    }

    /** The pictures that are seen, that of the studio first; if their difference is shown, in place of that. */
    List<Pane> panes() {
        Rectangle bounds = bounds();
        if (showsOtherAlone()) {
            return List.of(other(bounds, room()));
        }
        if (splits()) {
            int x = dividerX();
            Rectangle left = new Rectangle(bounds.x, bounds.y, x - bounds.x, bounds.height);
            Rectangle right = new Rectangle(x, bounds.y, bounds.x + bounds.width - x, bounds.height);
            return List.of(now(bounds, left.intersection(room())), other(bounds, right.intersection(room())));
        }
        return isBeside() && shown.otherImage() != null
                ? List.of(now(bounds, room()), other(otherBounds(), otherRoom()))
                : List.of(now(bounds, room()));
    }

    /** The studio's picture, in all of its room. */
    Pane studioPane() {
        return now(bounds(), room());
    }

    private Pane now(Rectangle bounds, Rectangle part) {
        return new Pane(shown.now(), showsDifference() ? shown.difference() : shown.nowImage(), false, bounds, part);
    }

    private Pane other(Rectangle bounds, Rectangle part) {
        return new Pane(shown.other(), shown.otherImage(), true, bounds, part);
    }

    /** The part of the canvas that the picture may cover. */
    Rectangle room() {
        return new Rectangle(space().size());
    }

    /** The room for each picture: of two, side by side or one above the other, whichever makes them larger. */
    Room space() {
        if (!isBeside()) {
            return new Room(canvas, zoom != null, false);
        }
        Room left = space(Math.max(1, (canvas.width - gap) / 2), canvas.height);
        Room upper = space(canvas.width, Math.max(1, (canvas.height - gap) / 2));
        return shown.now() != null && shown(upper).height > shown(left).height ? upper : left;
    }

    /** A panorama is whole, and so are the pictures of two eyes. */
    private Room space(int width, int height) {
        boolean whole = shown.now() == null
                || !(shown.now().studio().camera() instanceof ThinLensCamera lens)
                || lens.stereo().layout() != StereoLayout.NONE;
        return new Room(new Dimension(width, height), zoom != null, !whole);
    }

    private Dimension shown(Room room) {
        return room.shown(shown.now().ownWidth(), shown.now().ownHeight());
    }

    /** The size of the picture when it is not enlarged. */
    Dimension fitted() {
        return shown(space());
    }

    /** The part of the canvas that the other picture may cover. */
    Rectangle otherRoom() {
        Rectangle room = room();
        room.setLocation(canvas.width - room.width, canvas.height - room.height);
        return room;
    }

    /** Whether two pictures are seen. */
    boolean showsTwo() {
        return splits() || isBeside() && shown.otherImage() != null;
    }

    /** Whether a divider is seen. */
    boolean splits() {
        return comparison == Comparison.SPLIT && shown.otherImage() != null && !otherAlone;
    }

    /** Whether the other picture alone is seen. */
    boolean showsOtherAlone() {
        return otherAlone && shown.otherImage() != null;
    }

    /** Whether the difference of both is seen. */
    boolean showsDifference() {
        return comparison == Comparison.DIFFERENCE && shown.difference() != null && !otherAlone;
    }

    /** Where the divider is on the canvas. */
    int dividerX() {
        Rectangle bounds = bounds();
        return bounds.x + (int) Math.round(divider * bounds.width);
    }

    /**
     * The place of the photograph that is seen at a point of the canvas: the middle of the pixel of the picture, or of
     * the one beside it; null if there is none.
     */
    Point2D pictureAt(Point point) {
        Pane pane = paneAt(point);
        if (pane == null) {
            return null;
        }
        Rectangle bounds = pane.bounds;
        Picture now = shown.now();
        return now.middle((int) ((point.x + 0.5 - bounds.x) * now.width() / bounds.width), (int)
                ((point.y + 0.5 - bounds.y) * now.height() / bounds.height));
    }

    /** Where on the canvas a place of the photograph is seen. */
    Point pointOf(Point2D place) {
        Rectangle bounds = bounds();
        Picture now = shown.now();
        return new Point(
                bounds.x + (int) Math.floor(place.getX() * bounds.width / now.ownWidth()),
                bounds.y + (int) Math.floor(place.getY() * bounds.height / now.ownHeight()));
    }

    /** The picture that is seen at a place of the photograph. */
    Picture seenAt(Point2D place) {
        boolean beyond = splits() && place.getX() > divider * shown.now().ownWidth();
        return beyond || showsOtherAlone() ? shown.other() : shown.now();
    }
}
