package tompkins.ui.widget;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.FocusEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JComponent;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;

/** Scrolls to what the Tab key reaches, in a window and in those that it owns. */
public final class FocusFollower {

    private FocusFollower() {}

    /** Follows the focus until the window is closed. */
    public static void install(Window window) {
        AWTEventListener follower = event -> {
            if (event instanceof FocusEvent focus
                    && focus.getID() == FocusEvent.FOCUS_GAINED
                    && isTraversal(focus)
                    && belongsTo(window, focus.getComponent())) {
                show(focus.getComponent());
            }
        };
        Toolkit toolkit = Toolkit.getDefaultToolkit();
        toolkit.addAWTEventListener(follower, AWTEvent.FOCUS_EVENT_MASK);
        window.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                toolkit.removeAWTEventListener(follower);
            }
        });
    }

    /** Whether the Tab key brought the focus: what the mouse presses must not move away under it. */
    public static boolean isTraversal(FocusEvent event) {
        boolean forward = event.getCause() == FocusEvent.Cause.TRAVERSAL_FORWARD;
        return forward && !isLost(event.getOppositeComponent())
                || event.getCause() == FocusEvent.Cause.TRAVERSAL_BACKWARD;
    }

    /** Whether a component had to give up the focus, which then goes forward by itself. */
    private static boolean isLost(Component before) {
        return before != null && !(before.isShowing() && before.isEnabled());
    }

    private static boolean belongsTo(Window window, Component component) {
        Window own = SwingUtilities.getWindowAncestor(component);
        return own == window || own != null && own.getOwner() == window;
    }

    private static void show(Component component) {
        // a text field does not pass on such a request, and the view of a scroll pane is as large as everything in it
        if (component.getParent() instanceof JComponent parent && !(parent instanceof JViewport)) {
            parent.scrollRectToVisible(component.getBounds());
        }
    }
}
