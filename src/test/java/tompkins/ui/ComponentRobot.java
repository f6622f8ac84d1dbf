package tompkins.ui;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
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
final class ComponentRobot extends Robot {

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

    /** When and where a button went down last, and how often it was clicked there. */
    private long lastPress;

    private Point lastPlace = new Point();
    private int clicks;

    ComponentRobot() throws AWTException {
        EVENTS.install();
    }

    @Override
    public synchronized void mouseMove(int x, int y) {
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

    @Override
    public synchronized void mousePress(int button) {
        // what is under the mouse may have come or gone while that was still
        mouseMove(pointer.x, pointer.y);
        long now = System.currentTimeMillis();
        clicks = now - lastPress < 500 && lastPlace.equals(pointer) ? clicks + 1 : 1;
        lastPress = now;
        lastPlace = new Point(pointer);
        pressed = new Point(pointer);
        modifiers |= button;
        EVENTS.raise(under);
        mouse(MouseEvent.MOUSE_PRESSED, clicks, buttonOf(button));
    }

    @Override
    public synchronized void mouseRelease(int button) {
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
            EVENTS.give(new MouseEvent(
                    under,
                    id,
                    System.currentTimeMillis(),
                    modifiers,
                    place.x,
                    place.y,
                    pointer.x,
                    pointer.y,
                    count,
                    false,
                    button));
        }
    }

    private Point placeIn(Window window) {
        return WindowDriver.onEventThread(() -> {
            Point corner = window.isShowing() ? window.getLocationOnScreen() : window.getLocation();
            return new Point(pointer.x - corner.x, pointer.y - corner.y);
        });
    }

    @Override
    public synchronized void mouseWheel(int notches) {
        if (under != null) {
            Point place = placeIn(under);
            EVENTS.give(new MouseWheelEvent(
                    under,
                    MouseEvent.MOUSE_WHEEL,
                    System.currentTimeMillis(),
                    modifiers,
                    place.x,
                    place.y,
                    pointer.x,
                    pointer.y,
                    0,
                    false,
                    MouseWheelEvent.WHEEL_UNIT_SCROLL,
                    3,
                    notches));
        }
    }

    @Override
    public synchronized void keyPress(int code) {
        modifiers |= MODIFIERS.getOrDefault(code, 0);
        char letter = letterOf(code);
        key(KeyEvent.KEY_PRESSED, code, letter);
        if (letter != KeyEvent.CHAR_UNDEFINED) {
            key(KeyEvent.KEY_TYPED, KeyEvent.VK_UNDEFINED, letter);
        }
    }

    @Override
    public synchronized void keyRelease(int code) {
        modifiers &= ~MODIFIERS.getOrDefault(code, 0);
        key(KeyEvent.KEY_RELEASED, code, letterOf(code));
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

    /** Everything was handled when it was given. */
    @Override
    public synchronized void delay(int milliseconds) {}
}
