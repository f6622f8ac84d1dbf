package tompkins.ui.widget;

import java.awt.Component;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;

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

    /** Moves a window to the right of another as far as the screen goes, where it covers least of its picture. */
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
