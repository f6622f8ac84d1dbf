package tompkins.ui;

import java.awt.GraphicsDevice;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;

/**
 * The picture on all of the screen, for the lecture room: no frame, no menus, no panel, no line at the bottom. The keys
 * of the menus work on.
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
     * Nothing is covered yet.
     *
     * @param side the panel, which is not to be seen beside the picture unless somebody wants it there
     * @param hidden what is not to be seen there at all
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

    /** Covers the screen on which the window is, or gives it back. */
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

    /** Gives the screen back; false if it is not covered. */
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
