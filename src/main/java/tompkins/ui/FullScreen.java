package tompkins.ui;

import java.awt.GraphicsDevice;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;

/**
 * The picture on all of the screen, for the lecture room: no frame, no menus, no panel, no line at the bottom. The keys
 * of the menus work on, and what the user opens there stays.
 */
final class FullScreen {

    private final JFrame frame;
    private final List<JComponent> hidden;
    private final Runnable changed;

    /** What was hidden by it, and comes back with the window. */
    private List<JComponent> hiding = List.of();

    /** The screen that the window covers; null if it does not. */
    private GraphicsDevice covered;

    /**
     * Nothing is covered yet.
     *
     * @param hidden what is not to be seen beside the picture
     * @param changed told after the window has covered the screen, or does not any more
     */
    FullScreen(JFrame frame, List<JComponent> hidden, Runnable changed) {
        this.frame = frame;
        this.hidden = hidden;
        this.changed = changed;
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
            hiding = hidden.stream().filter(JComponent::isVisible).toList();
            hiding.forEach(component -> component.setVisible(false));
            covered = frame.getGraphicsConfiguration().getDevice();
            covered.setFullScreenWindow(frame);
            changed.run();
        }
    }

    /** Gives the screen back; false if it is not covered. */
    boolean leave() {
        if (!isOn()) {
            return false;
        }
        covered.setFullScreenWindow(null);
        covered = null;
        hiding.forEach(component -> component.setVisible(true));
        hiding = List.of();
        changed.run();
        return true;
    }
}
