package tompkins.ui.widget;

import java.awt.KeyboardFocusManager;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.text.JTextComponent;

/** What wrapped texts have in common: the height follows from the width, and Tab leaves the text. */
public final class WrappedText {

    private WrappedText() {}

    /** Makes a text behave so. */
    public static void prepare(JTextComponent text) {
        text.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        text.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        text.addComponentListener(new WidthFollower());
    }

    private static final class WidthFollower extends ComponentAdapter {

        private int width;

        @Override
        public void componentResized(ComponentEvent event) {
            if (event.getComponent().getWidth() != width) {
                width = event.getComponent().getWidth();
                // the height of wrapped text is known only when its width is
                event.getComponent().revalidate();
            }
        }
    }
}
