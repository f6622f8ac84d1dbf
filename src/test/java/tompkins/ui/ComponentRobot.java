package tompkins.ui;

import java.awt.Component;
import java.awt.Point;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Map;
import java.util.Set;

/**
 * Gives mouse and keys to the windows of this program alone, and keeps from them what happens on the screen: whoever
 * moves the mouse or takes the focus there disturbs no test, and is not disturbed. The window that was opened or
 * pressed last has the keys, wherever those of the screen are.
 */
final class ComponentRobot {

    private static final Map<Integer, Integer> MODIFIERS = Map.of(
            KeyEvent.VK_SHIFT, InputEvent.SHIFT_DOWN_MASK,
            KeyEvent.VK_CONTROL, InputEvent.CTRL_DOWN_MASK,
            KeyEvent.VK_ALT, InputEvent.ALT_DOWN_MASK);

    private static final OwnEvents EVENTS = OwnEvents.EVENTS;

    private final Point pointer = new Point(-1, -1);
    private int modifiers;

    /** The window under the mouse, or in which a button went down. */
    private Window under;

    /** Where a button went down. */
    private Point pressed;

    /** How many times the button went down for the present click: 2 for the second press of a double click. */
    private int clicks;

    synchronized void mouseMove(int x, int y) {
        pointer.move(x, y);
        if (pressed != null) {
            mouse(MouseEvent.MOUSE_DRAGGED, 0, 0);
            return;
        }
        Window now = WindowDriver.onEventThread(() -> EVENTS.windowAt(pointer));
        if (now != under) {
            mouse(MouseEvent.MOUSE_EXITED, 0, 0);
            under = now;
            mouse(MouseEvent.MOUSE_ENTERED, 0, 0);
        }
        mouse(MouseEvent.MOUSE_MOVED, 0, 0);
    }

    void mousePress(int button) {
        mousePress(button, 1);
    }

    /** Presses a button, for the second time at its place if {@code count} is 2: how fast a hand is plays no part. */
    synchronized void mousePress(int button, int count) {
        // what is under the mouse may have come or gone while that was still
        mouseMove(pointer.x, pointer.y);
        clicks = count;
        pressed = new Point(pointer);
        modifiers |= button;
        EVENTS.raise(under);
        mouse(MouseEvent.MOUSE_PRESSED, clicks, buttonOf(button));
    }

    synchronized void mouseRelease(int button) {
        modifiers &= ~button;
        boolean clicked = pointer.equals(pressed);
        pressed = null;
        mouse(MouseEvent.MOUSE_RELEASED, clicks, buttonOf(button));
        if (clicked) {
            mouse(MouseEvent.MOUSE_CLICKED, clicks, buttonOf(button));
        }
    }

    private static int buttonOf(int mask) {
        return mask == InputEvent.BUTTON1_DOWN_MASK ? MouseEvent.BUTTON1 : MouseEvent.BUTTON3;
    }

    private void mouse(int id, int count, int button) {
        if (under != null) {
            Point place = placeIn(under);
            long now = System.currentTimeMillis();
            EVENTS.give(new MouseEvent(under, id, now, modifiers, place.x, place.y, count, false, button));
        }
    }

    private Point placeIn(Window window) {
        return WindowDriver.onEventThread(() -> {
            Point corner = window.isShowing() ? window.getLocationOnScreen() : window.getLocation();
            return new Point(pointer.x - corner.x, pointer.y - corner.y);
        });
    }

    synchronized void mouseWheel(int notches) {
        if (under != null) {
            Point place = placeIn(under);
            EVENTS.give(new MouseWheelEvent(
                    under,
                    MouseEvent.MOUSE_WHEEL,
                    System.currentTimeMillis(),
                    modifiers,
                    place.x,
                    place.y,
                    0,
                    false,
                    MouseWheelEvent.WHEEL_UNIT_SCROLL,
                    3,
                    notches));
        }
    }

    synchronized void keyPress(int code) {
        modifiers |= MODIFIERS.getOrDefault(code, 0);
        char letter = letterOf(code);
        key(KeyEvent.KEY_PRESSED, code, letter);
        if (letter != KeyEvent.CHAR_UNDEFINED) {
            key(KeyEvent.KEY_TYPED, KeyEvent.VK_UNDEFINED, letter);
        }
    }

    synchronized void keyRelease(int code) {
        modifiers &= ~MODIFIERS.getOrDefault(code, 0);
        key(KeyEvent.KEY_RELEASED, code, letterOf(code));
    }

    /** Presses a key with a letter of another script, which Java sends without a code. */
    synchronized void keyPress(char letter) {
        key(KeyEvent.KEY_PRESSED, KeyEvent.VK_UNDEFINED, letter);
        key(KeyEvent.KEY_TYPED, KeyEvent.VK_UNDEFINED, letter);
        key(KeyEvent.KEY_RELEASED, KeyEvent.VK_UNDEFINED, letter);
    }

    private void key(int id, int code, char letter) {
        Component target = WindowDriver.onEventThread(EVENTS::keyTarget);
        if (target != null) {
            EVENTS.give(new KeyEvent(target, id, System.currentTimeMillis(), modifiers, code, letter));
        }
    }

    /** The letter of a key, as the keyboard of the United States has it. */
    private char letterOf(int code) {
        if (code >= KeyEvent.VK_A && code <= KeyEvent.VK_Z) {
            if ((modifiers & InputEvent.CTRL_DOWN_MASK) != 0) {
                return (char) (code - KeyEvent.VK_A + 1);
            }
            return (modifiers & InputEvent.SHIFT_DOWN_MASK) != 0 ? (char) code : Character.toLowerCase((char) code);
        }
        boolean written = code >= KeyEvent.VK_SPACE && code < KeyEvent.VK_A && !isArrow(code)
                || Set.of(KeyEvent.VK_ENTER, KeyEvent.VK_TAB, KeyEvent.VK_BACK_SPACE, KeyEvent.VK_ESCAPE)
                        .contains(code);
        return written ? (char) code : code == KeyEvent.VK_DELETE ? '\u007f' : KeyEvent.CHAR_UNDEFINED;
    }

    /** The codes of the arrows, and of the keys beside them, are those of letters. */
    private static boolean isArrow(int code) {
        return code >= KeyEvent.VK_PAGE_UP && code <= KeyEvent.VK_DOWN;
    }
}
