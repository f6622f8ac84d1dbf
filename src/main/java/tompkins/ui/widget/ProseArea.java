package tompkins.ui.widget;

import java.awt.KeyboardFocusManager;
import javax.swing.UIManager;

/** A field for text of several lines, as high as the text needs; Tab leaves it like any other field. */
@SuppressWarnings("serial") // never written to a stream
public final class ProseArea extends WrappingArea {

    private static final int ROWS = 3;

    /** An empty field. */
    public ProseArea() {
        super(ROWS);
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(UIManager.getFont("TextField.font"));
        setBorder(UIManager.getBorder("TextField.border"));
        setMargin(UIManager.getInsets("TextField.margin"));
    }
}
