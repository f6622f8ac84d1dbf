package tompkins.ui.picture;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;

/** What the mouse does on a canvas: it points, clicks, and drags the divider. */
public final class CanvasMouse extends MouseAdapter {

    private static final int GRIP = 6;

    /** How far a press may move and still be a click, because hands shake. */
    private static final int LARGEST_CLICK = 5;

    private final PictureCanvas canvas;
    private Point pressed = new Point();
    private boolean draggingDivider;
    private boolean dragged;

    /** By how much the wheel was turned since the last step; a touchpad makes many small turns for one step. */
    private double turned;

    CanvasMouse(PictureCanvas canvas) {
        this.canvas = canvas;
        canvas.addMouseListener(this);
        canvas.addMouseMotionListener(this);
        canvas.addMouseWheelListener(this);
    }

    /** Whether a drag that begins at a point moves the divider. */
    public boolean isNearDivider(Point point) {
        return Math.abs(point.x - canvas.dividerX()) <= GRIP;
    }

    /** Whether the mouse has moved too far since its button was pressed for a click. */
    public boolean isDragging() {
        return dragged;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        canvas.requestFocusInWindow();
        draggingDivider = isNearDivider(event.getPoint());
        pressed = event.getPoint();
        dragged = false;
        offerMenu(event);
    }

    /** Some systems ask for a menu when a button is pressed, others when it is released. */
    private void offerMenu(MouseEvent event) {
        if (event.isPopupTrigger() && !dragged) {
            // it is no click then
            dragged = true;
            canvas.pointMouse(event.getPoint());
            canvas.askForMenu();
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        Point before = canvas.mouseAt();
        dragged |= event.getPoint().distance(pressed) > LARGEST_CLICK;
        if (SwingUtilities.isMiddleMouseButton(event) && before != null) {
            canvas.pointMouse(event.getPoint());
            canvas.zoom().pan(event.getX() - before.x, event.getY() - before.y);
        } else if (draggingDivider) {
            canvas.pointMouse(event.getPoint());
            Rectangle bounds = canvas.pictureBounds();
            canvas.setDivider((double) (event.getX() - bounds.x) / bounds.width);
        } else {
            mouseMoved(event);
        }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        canvas.setCursor(Cursor.getPredefinedCursor(
                isNearDivider(event.getPoint())
                        ? Cursor.E_RESIZE_CURSOR
                        : canvas.tool().cursor()));
        canvas.pointMouse(event.getPoint());
        canvas.tellPointed();
    }

    @Override
    public void mouseExited(MouseEvent event) {
        canvas.pointMouse(null);
        canvas.tellPointed();
    }

    /** With Alt, the wheel enlarges the picture when it is turned away from the hand, as elsewhere. */
    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        if (event.isAltDown()) {
            canvas.pointMouse(event.getPoint());
            turned += event.getPreciseWheelRotation();
            for (; turned <= -1; turned++) {
                canvas.zoom().enlarge();
            }
            for (; turned >= 1; turned--) {
                canvas.zoom().reduce();
            }
        }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        offerMenu(event);
        if (!draggingDivider && !dragged && event.getButton() == MouseEvent.BUTTON1) {
            canvas.pointMouse(event.getPoint());
            if (event.getClickCount() == 2) {
                canvas.clickAgain();
            } else {
                canvas.click();
            }
        }
        draggingDivider = false;
    }
}
