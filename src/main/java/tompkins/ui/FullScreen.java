package tompkins.ui;

import java.awt.GraphicsDevice;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;

/**
 * Shows the picture on the whole screen, for the lecture room: no frame, no menus, no panel, no line at the bottom. The
 * keys of the menus keep working.
 */
final class FullScreen {

    private final JFrame frame;
    private final List<JComponent> hidden;
    private final SideRoom side;

    /** Whether the panel comes back with the window. */
    private boolean withPanel;

    /** The screen that the window covers; null if it does not. */
    private GraphicsDevice covered;

    /**
     * A full screen that is off.
     *
     * @param side the panel, which is hidden unless the user asks for it
     * @param hidden what is always hidden
     */
    FullScreen(JFrame frame, SideRoom side, List<JComponent> hidden) {
        this.frame = frame;
        this.side = side;
        this.hidden = hidden;
    }

    /** Whether the window covers its screen. */
    boolean isOn() {
        return covered != null;
    }

    /** Covers the screen on which the window is, or uncovers it. */
    void toggle() {
        if (isOn()) {
            leave();
        } else {
            withPanel = side.isWanted();
            side.setShown(false);
            hidden.forEach(component -> component.setVisible(false));
            covered = frame.getGraphicsConfiguration().getDevice();
            covered.setFullScreenWindow(frame);
            frame.revalidate();
        }
    }

    /** Uncovers the screen; false if it is not covered. */
    boolean leave() {
        if (!isOn()) {
            return false;
        }
        covered.setFullScreenWindow(null);
        covered = null;
        hidden.forEach(component -> component.setVisible(true));
        if (withPanel) {
            side.setShown(true);
        }
        frame.revalidate();
        return true;
    }
}
