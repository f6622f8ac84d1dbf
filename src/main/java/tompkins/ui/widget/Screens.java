package tompkins.ui.widget;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;

/** The screens, of which there may be several, such as a projector beside that of a laptop. */
public final class Screens {

    private Screens() {}

    /** The part of the screen of a window, or of a component in one, that windows may cover, without task bars. */
    public static Rectangle room(Component component) {
        GraphicsConfiguration screen = component.getGraphicsConfiguration();
        Rectangle bounds = screen.getBounds();
        Insets taken = Toolkit.getDefaultToolkit().getScreenInsets(screen);
        return new Rectangle(
                bounds.x + taken.left,
                bounds.y + taken.top,
                bounds.width - taken.left - taken.right,
                bounds.height - taken.top - taken.bottom);
    }

    /**
     * A size, or that of the screen of a window if that is smaller: large type, or a size remembered from another
     * screen, may not fit.
     */
    public static Dimension atMost(Component window, int width, int height) {
        Rectangle screen = room(window);
        return new Dimension(Math.min(width, screen.width), Math.min(height, screen.height));
    }

    /**
     * Keeps the dialogs of a window on their screen when they open, until the window is closed.
     *
     * @param asking told when one of them wants an answer before the window can be used again
     */
    public static void keepDialogsOnScreen(Window window, Runnable asking) {
        AWTEventListener watcher = event -> {
            if (event.getID() == WindowEvent.WINDOW_OPENED
                    && event.getSource() instanceof Dialog dialog
                    && isOwner(window, dialog)) {
                keepOnScreen(dialog);
                if (dialog.isModal()) {
                    asking.run();
                }
            }
        };
        watch(window, watcher, AWTEvent.WINDOW_EVENT_MASK);
    }

    /** Tells of some kinds of events in all windows, until one window is closed. */
    static void watch(Window window, AWTEventListener watcher, long kinds) {
        Toolkit toolkit = Toolkit.getDefaultToolkit();
        toolkit.addAWTEventListener(watcher, kinds);
        window.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                toolkit.removeAWTEventListener(watcher);
            }
        });
    }

    private static boolean isOwner(Window window, Window owned) {
        return owned != null && (owned.getOwner() == window || isOwner(window, owned.getOwner()));
    }

    /**
     * Moves a window to the right of another as far as the screen allows, so that it covers as little of its picture as
     * possible.
     */
    public static void moveBeside(Window window, Window owner) {
        window.setLocation(owner.getX() + owner.getWidth(), owner.getY());
        keepOnScreen(window);
    }

    /** Moves a window, and makes it smaller if need be, so that all of it is on its screen. */
    public static void keepOnScreen(Window window) {
        Rectangle screen = room(window);
        window.setSize(Math.min(window.getWidth(), screen.width), Math.min(window.getHeight(), screen.height));
        window.setLocation(
                Math.max(screen.x, Math.min(window.getX(), screen.x + screen.width - window.getWidth())),
                Math.max(screen.y, Math.min(window.getY(), screen.y + screen.height - window.getHeight())));
    }
}
