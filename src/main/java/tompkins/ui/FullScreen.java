package tompkins.ui;

import java.awt.Frame;
import java.awt.GraphicsDevice;
import java.awt.Point;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.Timer;

/**
 * Shows the picture on the whole screen, for the lecture room: no frame, no menus, no panel, no line at the bottom. The
 * keys of the menus keep working.
 */
final class FullScreen {

    /** The time that a window manager takes, and nobody needs for an answer. */
    private static final int SETTLED_MILLISECONDS = 300;

    private final JFrame frame;
    private final List<JComponent> hidden;
    private final JComponent side;

    /** Whether the panel comes back with the window. */
    private boolean withPanel;

    /** The screen that the window covers; null if it does not. */
    private GraphicsDevice covered;

    /** Where the window was before. */
    private Point place;

    /** Some window managers put the window back and leave Java in the belief that it is elsewhere; then menus are. */
    private final Timer settling = new Timer(SETTLED_MILLISECONDS, event -> putBack());

    /**
     * A full screen that is off.
     *
     * @param side the panel, which is hidden unless the user asks for it
     * @param hidden what is always hidden
     */
    FullScreen(JFrame frame, JComponent side, List<JComponent> hidden) {
        this.frame = frame;
        this.side = side;
        this.hidden = hidden;
        settling.setRepeats(false);
    }

    /** Covers the screen on which the window is, or uncovers it. */
    void toggle() {
        if (!leave()) {
            withPanel = side.isVisible();
            side.setVisible(false);
            hidden.forEach(component -> component.setVisible(false));
            if (!settling.isRunning()) {
                place = frame.getLocation();
            }
            settling.stop();
            covered = frame.getGraphicsConfiguration().getDevice();
            covered.setFullScreenWindow(frame);
            frame.revalidate();
        }
    }

    /** Uncovers the screen; false if it is not covered. */
    boolean leave() {
        if (covered == null) {
            return false;
        }
        covered.setFullScreenWindow(null);
        covered = null;
        settling.restart();
        hidden.forEach(component -> component.setVisible(true));
        if (withPanel) {
            side.setVisible(true);
        }
        frame.revalidate();
        return true;
    }

    private void putBack() {
        if (frame.getExtendedState() == Frame.NORMAL && !frame.getLocation().equals(place)) {
            // the window learns its place only if it moves
            frame.setLocation(place.x + 1, place.y);
            frame.setLocation(place);
        }
    }
}
