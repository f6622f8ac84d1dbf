package tompkins.ui.widget;

import java.awt.KeyboardFocusManager;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JTextArea;
import javax.swing.text.JTextComponent;

/** Text that is wrapped between words and has the height that this needs; Tab leaves it like any other field. */
@SuppressWarnings("serial") // never written to a stream
public class WrappingArea extends JTextArea {

    /** An area of any width, with a height of at least some rows; 0 for none. */
    WrappingArea(int rows) {
        super(rows, 1);
        setLineWrap(true);
        setWrapStyleWord(true);
        behaveWrapped(this);
    }

    /** Makes a text behave as wrapped ones do: its height follows from its width, and Tab leaves it. */
    public static void behaveWrapped(JTextComponent text) {
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
