package tompkins.ui.widget;

import java.awt.Component;
import java.awt.Insets;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import javax.swing.text.TextAction;

/**
 * Keeps keys from text that a layout has squeezed to nothing: Swing looks there for the line of the caret, finds none,
 * and fails.
 */
public final class SqueezedText implements KeyEventDispatcher {

    private static final SqueezedText INSTANCE = new SqueezedText();

    private SqueezedText() {}

    /** Guards all text of the program. Called by the event thread; may be called several times. */
    static void guard() {
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        manager.removeKeyEventDispatcher(INSTANCE);
        manager.addKeyEventDispatcher(INSTANCE);
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return owner instanceof JTextComponent text && isSqueezed(text) && isForText(event, text);
    }

    /** Whether a text has no room inside its margins. */
    private static boolean isSqueezed(JTextComponent text) {
        Insets insets = text.getInsets();
        return text.getWidth() <= insets.left + insets.right || text.getHeight() <= insets.top + insets.bottom;
    }

    private static boolean isForText(KeyEvent event, JTextComponent text) {
        Object name = text.getInputMap().get(KeyStroke.getKeyStrokeForEvent(event));
        return name != null && text.getActionMap().get(name) instanceof TextAction;
    }
}
