package tompkins.ui.picture;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.util.List;
import javax.swing.KeyStroke;
import tompkins.ui.widget.Keys;

/**
 * Does with the keys what the mouse can do on a picture: the arrows move a ring, pixel by pixel or with Shift by ten,
 * and Enter clicks in it. With Ctrl, the arrows to the left and right move the divider.
 */
final class KeyPointer {

    private static final int FAR = 10;

    /** How far a key moves the divider, as a share of the picture's width. */
    private static final double DIVIDER_STEP = 0.02;

    private final PictureCanvas canvas;

    /** Column and row of the pixel of the photograph in the ring, or null if there is none. */
    private Point pixel;

    /** A pointer that appears when the Tab key reaches the picture, or with the first arrow. */
    KeyPointer(PictureCanvas canvas) {
        this.canvas = canvas;
        bind("LEFT", -1, 0);
        bind("RIGHT", 1, 0);
        bind("UP", 0, -1);
        bind("DOWN", 0, 1);
        Keys.bindFocused(canvas, KeyStroke.getKeyStroke("ctrl LEFT"), () -> moveDivider(-DIVIDER_STEP));
        Keys.bindFocused(canvas, KeyStroke.getKeyStroke("ctrl RIGHT"), () -> moveDivider(DIVIDER_STEP));
        Keys.bindFocused(canvas, KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), this::click);
        for (String key : List.of("CONTEXT_MENU", "shift F10")) {
            Keys.bindFocused(canvas, KeyStroke.getKeyStroke(key), canvas::askForMenu);
        }
        canvas.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                if (isTraversal(event)) {
                    move(0, 0);
                }
            }

            @Override
            public void focusLost(FocusEvent event) {
                if (pixel != null && !event.isTemporary()) {
                    forget();
                    canvas.tellPointed();
                }
            }
        });
    }

    /** Whether the Tab key brought the focus. */
    private static boolean isTraversal(FocusEvent event) {
        Component before = event.getOppositeComponent();
        // from what had to give it up it goes forward by itself
        boolean isLost = before != null && !(before.isShowing() && before.isEnabled());
        return event.getCause() == FocusEvent.Cause.TRAVERSAL_FORWARD && !isLost
                || event.getCause() == FocusEvent.Cause.TRAVERSAL_BACKWARD;
    }

    private void bind(String key, int right, int down) {
        Keys.bindFocused(canvas, KeyStroke.getKeyStroke(key), () -> move(right, down));
        Keys.bindFocused(canvas, KeyStroke.getKeyStroke("shift " + key), () -> move(FAR * right, FAR * down));
    }

    private void moveDivider(double right) {
        if (canvas.splits()) {
            canvas.setDivider(canvas.divider() + right);
        }
    }

    private void move(int right, int down) {
        Picture picture = canvas.shown().now();
        if (picture == null) {
            return;
        }
        Point from = pixel != null && picture.holds(pixel)
                ? pixel
                : new Point(picture.ownWidth() / 2, picture.ownHeight() / 2);
        Point next = new Point(from.x + right, from.y + down);
        pixel = picture.holds(next) && canReach(next) ? next : from;
        canvas.zoom().show(place());
        canvas.tellPointed();
        canvas.repaint();
    }

    /** Whether a pixel is on the canvas, or is brought there; of a picture that fills its room the edges are not. */
    private boolean canReach(Point next) {
        PictureArrangement seen = canvas.arrangement();
        return seen.zoom() != null
                || seen.room().contains(seen.pointOf(new Point2D.Double(next.x + 0.5, next.y + 0.5)));
    }

    /** Points at the middle of the picture, if it points nowhere. */
    void pointAtMiddle() {
        move(0, 0);
    }

    /** The middle of the pixel in the ring, as a place of the photograph; null if there is none. */
    Point2D place() {
        Picture picture = canvas.shown().now();
        return pixel != null && picture != null && picture.holds(pixel)
                ? new Point2D.Double(pixel.x + 0.5, pixel.y + 0.5)
                : null;
    }

    private void click() {
        if (place() != null) {
            canvas.click();
        }
    }

    /** Forgets the ring, because the mouse points now. */
    void forget() {
        if (pixel != null) {
            pixel = null;
            canvas.repaint();
        }
    }
}
