package tompkins.ui.widget;

import java.awt.KeyboardFocusManager;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;

/** Text that is wrapped between words and as high as it then needs to be; Tab leaves it like any other field. */
@SuppressWarnings("serial") // never written to a stream
class WrappingArea extends JTextArea {

    /** An area of any width, with a height of at least some rows; 0 for none. */
    WrappingArea(int rows) {
        super(rows, 1);
        setLineWrap(true);
        setWrapStyleWord(true);
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean otherWidth = width != getWidth();
        super.setBounds(x, y, width, height);
        if (otherWidth) {
            // the height of wrapped text is known only when its width is
            SwingUtilities.invokeLater(this::revalidate);
        }
    }
}
