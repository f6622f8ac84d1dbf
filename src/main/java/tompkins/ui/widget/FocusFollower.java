package tompkins.ui.widget;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import javax.swing.JComponent;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;

/**
 * Scrolls to what has the focus, in a window and in those that it owns, as long as the user works with the keys: when
 * the focus comes, and again when something above it becomes longer or shorter, or less of it is seen. What the mouse
 * presses stays where it is, and so does what the wheel scrolls to.
 */
public final class FocusFollower implements AWTEventListener {

    private static final long EVENTS = AWTEvent.FOCUS_EVENT_MASK
            | AWTEvent.COMPONENT_EVENT_MASK
            | AWTEvent.KEY_EVENT_MASK
            | AWTEvent.MOUSE_EVENT_MASK
            | AWTEvent.MOUSE_WHEEL_EVENT_MASK;

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
            case MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_WHEEL -> usesKeys = false;
            case FocusEvent.FOCUS_GAINED -> follow((Component) event.getSource());
            case ComponentEvent.COMPONENT_MOVED, ComponentEvent.COMPONENT_RESIZED ->
                laidOut((Component) event.getSource(), event.getID() == ComponentEvent.COMPONENT_MOVED);
            default -> {}
        }
    }

    /** Follows what the layout moves and how much of it is seen; not what is scrolled. */
    private void laidOut(Component changed, boolean isMoved) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        boolean isScrolled = isMoved && changed.getParent() instanceof JViewport;
        if (owner != null && !isScrolled && SwingUtilities.isDescendingFrom(owner, changed)) {
            follow(owner);
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
