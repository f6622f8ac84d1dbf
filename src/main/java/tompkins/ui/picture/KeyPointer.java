package tompkins.ui.picture;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import javax.swing.KeyStroke;
import tompkins.ui.widget.FocusFollower;
import tompkins.ui.widget.Keys;

/**
 * What the mouse can do on a picture, with the keys: the arrows move a ring, pixel by pixel or with Shift by ten, and
 * Enter clicks in it. With Ctrl, the arrows to the left and right move the divider.
 */
final class KeyPointer {

    private static final int FAR = 10;

    /** How far a key moves the divider, as a share of the picture's width. */
    private static final double DIVIDER_STEP = 0.02;

    private final PictureCanvas canvas;

    /** The place of the photograph in the ring, or null if there is none. */
    private Point2D at;

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
        canvas.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                if (FocusFollower.isTraversal(event)) {
                    move(0, 0);
                }
            }

            @Override
            public void focusLost(FocusEvent event) {
                if (at != null && !event.isTemporary()) {
                    forget();
                    canvas.tellPointed();
                }
            }
        });
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
        Point2D before = place();
        Point2D from = before == null
                ? new Point2D.Double(
                        picture.image().width() / 2, picture.image().height() / 2)
                : picture.inPixels(before);
        Point next = new Point((int) from.getX() + right, (int) from.getY() + down);
        if (new Rectangle(picture.image().width(), picture.image().height()).contains(next)) {
            at = picture.middle(next.x, next.y);
        } else if (before == null) {
            at = picture.middle((int) from.getX(), (int) from.getY());
        }
        canvas.zoom().show(at);
        canvas.tellPointed();
        canvas.repaint();
    }

    /** The middle of the pixel in the ring, as a place of the photograph; null if there is none. */
    Point2D place() {
        Picture picture = canvas.shown().now();
        if (at == null || picture == null || !picture.holds(at)) {
            return null;
        }
        Point2D pixel = picture.inPixels(at);
        return picture.middle((int) pixel.getX(), (int) pixel.getY());
    }

    private void click() {
        if (place() != null) {
            canvas.click();
        }
    }

    /** The mouse points now. */
    void forget() {
        if (at != null) {
            at = null;
            canvas.repaint();
        }
    }
}
