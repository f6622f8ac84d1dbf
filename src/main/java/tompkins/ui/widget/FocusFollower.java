package tompkins.ui.widget;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import javax.swing.JComponent;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;

/**
 * Scrolls to what gets the focus, in a window and in those that it owns, as long as the user works with the keys. What
 * the mouse presses stays where it is.
 */
public final class FocusFollower implements AWTEventListener {

    private static final long EVENTS = AWTEvent.FOCUS_EVENT_MASK | AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK;

    private final Window window;

    /** Whether the user pressed a key last, and not the mouse. The cause of a focus event does not tell it reliably. */
    private boolean usesKeys;

    private FocusFollower(Window window) {
        this.window = window;
    }

    /** Follows the focus until the window is closed. */
    public static void install(Window window) {
        Screens.watch(window, new FocusFollower(window), EVENTS);
    }

    @Override
    public void eventDispatched(AWTEvent event) {
        switch (event.getID()) {
            case KeyEvent.KEY_PRESSED -> usesKeys = true;
            case MouseEvent.MOUSE_PRESSED -> usesKeys = false;
            case FocusEvent.FOCUS_GAINED -> follow((Component) event.getSource());
            default -> {}
        }
    }

    private void follow(Component component) {
        // a text field does not pass on such a request, and the view of a scroll pane is as large as everything in it
        if (usesKeys
                && belongsToWindow(component)
                && component.getParent() instanceof JComponent parent
                && !(parent instanceof JViewport)) {
            parent.scrollRectToVisible(component.getBounds());
        }
    }

    private boolean belongsToWindow(Component component) {
        Window own = SwingUtilities.getWindowAncestor(component);
        return own == window || own != null && own.getOwner() == window;
    }
}
