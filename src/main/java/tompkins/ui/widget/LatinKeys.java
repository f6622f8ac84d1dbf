package tompkins.ui.widget;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;

/**
 * Gives a key with a letter of another script the code of the Latin letter that an American keyboard has in its place:
 * Java gives it none, so that no key of the menus or of a text would work, such as Ctrl+Z on a Russian keyboard.
 */
public final class LatinKeys implements KeyEventDispatcher {

    private static final LatinKeys INSTANCE = new LatinKeys();

    /** The letters of an American keyboard, row by row. */
    private static final String LATIN = "QWERTYUIOPASDFGHJKLZXCVBNM";

    private LatinKeys() {}

    /** Serves all windows of the program. Called by the event thread; may be called several times. */
    static void install() {
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        manager.removeKeyEventDispatcher(INSTANCE);
        manager.addKeyEventDispatcher(INSTANCE);
    }

    /** The code of the key in the place of a letter of another script, or of a digit; no code for other letters. */
    public static int code(char letter) {
        char small = Character.toLowerCase(letter);
        if (small < 0x80) {
            return KeyEvent.VK_UNDEFINED;
        }
        if (Character.isDigit(small)) {
            return KeyEvent.VK_0 + Character.digit(small, 10);
        }
        return Texts.get("keys.places")
                .lines()
                .map(row -> row.indexOf(small))
                .filter(place -> place >= 0)
                .findFirst()
                .map(place -> (int) LATIN.charAt(place))
                .orElse(KeyEvent.VK_UNDEFINED);
    }

    /** The letter on a key; one that types none may still have a letter in its code. */
    public static char letter(KeyEvent event) {
        return event.getKeyChar() == KeyEvent.CHAR_UNDEFINED ? (char) event.getExtendedKeyCode() : event.getKeyChar();
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        // with Shift, a key may type what has a code of its own; its extended code is that of the key alone
        int code = code((char) event.getExtendedKeyCode());
        if (code == KeyEvent.VK_UNDEFINED) {
            code = code(letter(event));
        }
        if (code != KeyEvent.VK_UNDEFINED && event.getID() != KeyEvent.KEY_TYPED) {
            event.setKeyCode(code);
        }
        return false;
    }
}
