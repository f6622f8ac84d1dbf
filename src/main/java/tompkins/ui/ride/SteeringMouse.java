package tompkins.ui.ride;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import tompkins.camera.Aim.PicturePosition;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.Keys;

/** Steers the camera with the mouse and with the keys on a canvas. */
final class SteeringMouse extends MouseAdapter {

    /** Turns of the wheel, or strokes of a key, that follow each other within this time belong to one gesture. */
    private static final int PAUSE_MILLISECONDS = 500;

    private final PictureCanvas canvas;
    private final Steering steering;
    private final Timer pause;

    /** Where the picture lies that is dragged; null if none is. */
    private Rectangle dragged;

    private PicturePosition from;

    /** What began the gesture that goes on: a key, or the wheel with or without Ctrl; null if none goes on. */
    private Object source;

    /** Steers by what a hand does on a canvas. */
    SteeringMouse(PictureCanvas canvas, Steering steering) {
        this.canvas = canvas;
        this.steering = steering;
        pause = new Timer(PAUSE_MILLISECONDS, event -> begin(null));
        pause.setRepeats(false);
        canvas.setCentring(this::lookAt);
        canvas.addMouseListener(this);
        canvas.addMouseMotionListener(this);
        canvas.addMouseWheelListener(this);
        arrows("alt", steering::turn);
        arrows("alt shift", (right, up) -> steering.slide(pointed(), right, up));
        key(KeyStroke.getKeyStroke("alt PAGE_UP"), () -> steering.approach(pointed(), -1));
        key(KeyStroke.getKeyStroke("alt PAGE_DOWN"), () -> steering.approach(pointed(), 1));
        for (char plus : new char[] {'+', '='}) {
            key(KeyStroke.getKeyStroke(plus), () -> steering.zoom(pointed(), -1));
        }
        key(KeyStroke.getKeyStroke('-'), () -> steering.zoom(pointed(), 1));
        key(KeyStroke.getKeyStroke(KeyEvent.VK_C, 0), () -> steering.centre(pointed()));
    }

    private void arrows(String modifiers, RideKeys.Turn arrow) {
        key(KeyStroke.getKeyStroke(modifiers + " LEFT"), () -> arrow.by(-1, 0));
        key(KeyStroke.getKeyStroke(modifiers + " RIGHT"), () -> arrow.by(1, 0));
        key(KeyStroke.getKeyStroke(modifiers + " UP"), () -> arrow.by(0, 1));
        key(KeyStroke.getKeyStroke(modifiers + " DOWN"), () -> arrow.by(0, -1));
    }

    private void key(KeyStroke key, Runnable action) {
        Keys.bindFocused(canvas, key, () -> {
            if (canvas.shown().now() != null) {
                begin(key);
                action.run();
            }
        });
    }

    /** Begins a gesture, or continues the present one if it has the same source. */
    private void begin(Object newSource) {
        if (source != null && !source.equals(newSource)) {
            steering.letGo();
        }
        source = newSource;
        if (newSource == null) {
            pause.stop();
        } else {
            pause.restart();
        }
    }

    /** The place that the keys or else the mouse points at, or the middle. */
    private PicturePosition pointed() {
        Picture picture = canvas.shown().now();
        Point2D place = canvas.pointedPlace();
        return position(
                place == null ? new Point2D.Double(picture.ownWidth() / 2.0, picture.ownHeight() / 2.0) : place);
    }

    private PicturePosition position(Point2D place) {
        Picture picture = canvas.shown().now();
        return new PicturePosition(place.getX(), place.getY(), picture.ownWidth(), picture.ownHeight());
    }

    /** The place of the picture at a point of the canvas, which may lie outside the picture. */
    private PicturePosition place(Point point, Rectangle bounds) {
        Picture picture = canvas.shown().now();
        return position(new Point2D.Double(
                (point.x + 0.5 - bounds.x) / bounds.width * picture.ownWidth(),
                (point.y + 0.5 - bounds.y) / bounds.height * picture.ownHeight()));
    }

    /** Turns the camera by steps to the right and up. */
    void turn(int right, int up) {
        begin(RideKeys.class);
        steering.turn(right, up);
    }

    /** Turns the camera to what is at a place of the picture. */
    void lookAt(Point2D place) {
        begin(null);
        steering.centre(position(place));
    }

    @Override
    public void mousePressed(MouseEvent event) {
        boolean steers =
                SwingUtilities.isLeftMouseButton(event) && !canvas.hand().isNearDivider(event.getPoint());
        dragged = steers ? canvas.boundsAt(event.getPoint()) : null;
        if (dragged != null) {
            begin(null);
            from = place(event.getPoint(), dragged);
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (dragged == null || !canvas.hand().isDragging()) {
            return;
        }
        PicturePosition to = place(event.getPoint(), dragged);
        if (event.isShiftDown()) {
            steering.slide(from, to);
        } else {
            steering.turn(from, to);
        }
        from = to;
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (dragged != null && canvas.hand().isDragging()) {
            steering.letGo();
        }
        dragged = null;
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        Rectangle bounds = canvas.boundsAt(event.getPoint());
        if (bounds == null || event.isAltDown() || event.isShiftDown()) {
            return;
        }
        begin(event.isControlDown());
        PicturePosition place = place(event.getPoint(), bounds);
        if (event.isControlDown()) {
            steering.approach(place, event.getPreciseWheelRotation());
        } else {
            steering.zoom(place, event.getPreciseWheelRotation());
        }
    }
}
