package tompkins.ui.ride;

import java.awt.Component;
import java.awt.KeyEventPostProcessor;
import java.awt.KeyboardFocusManager;
import java.awt.event.InputEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeListener;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.text.JTextComponent;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.LatinKeys;

/**
 * The keys of a ride on a canvas: those that are held down give thrust. Letters count by where they lie; the arrows,
 * Shift and the page keys do the same without letters. Some displays repeat a key that is held by releasing it for a
 * moment each time; only a key that stays released counts.
 */
final class RideKeys {

    private static final int REPEAT_MILLISECONDS = 20;

    /** The property of the focus that tells that another component has the keys, or another window. */
    private static final String FOCUS = "focusOwner";

    private static final Vector3dc FORWARDS = new Vector3d(0, 0, 1);
    private static final Vector3dc BACK = new Vector3d(0, 0, -1);
    private static final Vector3dc LEFT = new Vector3d(-1, 0, 0);
    private static final Vector3dc RIGHT = new Vector3d(1, 0, 0);
    private static final Vector3dc DOWN = new Vector3d(0, -1, 0);
    private static final Vector3dc UP = new Vector3d(0, 1, 0);

    /** The thrust of each letter but the last, in the order of {@link RideKeyboard}. */
    private static final List<Vector3dc> LETTERS = List.of(FORWARDS, LEFT, BACK, RIGHT, DOWN, UP);

    private static final Map<Integer, Vector3dc> ARROWS = Map.of(KeyEvent.VK_UP, FORWARDS, KeyEvent.VK_DOWN, BACK);

    private static final Map<Integer, Vector3dc> WITH_SHIFT = Map.of(
            KeyEvent.VK_UP, FORWARDS,
            KeyEvent.VK_DOWN, BACK,
            KeyEvent.VK_LEFT, LEFT,
            KeyEvent.VK_RIGHT, RIGHT,
            KeyEvent.VK_PAGE_DOWN, DOWN,
            KeyEvent.VK_PAGE_UP, UP);

    /** A key that is held: its thrust, and what ends it soon after the key is released. */
    private record Held(Vector3dc thrust, Timer ending) {}

    private final PictureCanvas canvas;
    private final RidePilot pilot;
    private final Turn turn;
    private final KeyEventPostProcessor elsewhere = this::takeUnused;
    private final PropertyChangeListener focus = event -> letGo();
    private final Map<Integer, Held> held = new HashMap<>();
    private RideKeyboard keyboard = RideKeyboard.common().get(0);
    private boolean listens;

    /** What turns the view by steps to the right and up. */
    interface Turn {

        void by(int right, int up);
    }

    /** Listens to the keys of a canvas. */
    RideKeys(PictureCanvas canvas, RidePilot pilot, Turn turn) {
        this.pilot = pilot;
        this.turn = turn;
        this.canvas = canvas;
        canvas.addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent event) {
                take(event);
            }

            @Override
            public void keyReleased(KeyEvent event) {
                take(event);
            }

            @Override
            public void keyTyped(KeyEvent event) {
                take(event);
            }
        });
        pilot.addListener(this::listenElsewhere);
    }

    /** Lets the letters of another keyboard steer from now on. */
    void setKeyboard(RideKeyboard other) {
        keyboard = other;
    }

    /** While the camera flies, keys that have no use where the focus is steer it: a switch was clicked, for example. */
    private void listenElsewhere() {
        if (listens == pilot.isFlying()) {
            return;
        }
        listens = !listens;
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        if (listens) {
            manager.addKeyEventPostProcessor(elsewhere);
            manager.addPropertyChangeListener(FOCUS, focus);
        } else {
            manager.removeKeyEventPostProcessor(elsewhere);
            manager.removePropertyChangeListener(FOCUS, focus);
            letGo();
        }
    }

    private boolean takeUnused(KeyEvent event) {
        Component focused = event.getComponent();
        if (!event.isConsumed()
                && focused != canvas
                && !(focused instanceof JTextComponent)
                && SwingUtilities.getRoot(focused) == SwingUtilities.getRoot(canvas)) {
            take(event);
        }
        return event.isConsumed();
    }

    private void take(KeyEvent event) {
        switch (event.getID()) {
            case KeyEvent.KEY_RELEASED -> {
                Held ending = held.get(key(event));
                if (ending != null) {
                    ending.ending.restart();
                }
            }
            case KeyEvent.KEY_PRESSED -> {
                if (isOfRide(event)) {
                    press(event);
                } else if (event.getModifiersEx() == 0 && event.getKeyCode() == KeyEvent.VK_HOME) {
                    // a ride that is paused begins anew, too, and a replay ends
                    pilot.home();
                }
            }
            default -> {
                // letters of a ride mean nothing else
                if (isOfRide(event)) {
                    event.consume();
                }
            }
        }
    }

    private boolean isOfRide(KeyEvent event) {
        return pilot.isFlying() && (event.getModifiersEx() & ~InputEvent.SHIFT_DOWN_MASK) == 0;
    }

    /** The same number when a key is pressed and when it is released, also for letters without a code of their own. */
    private static int key(KeyEvent event) {
        return event.getKeyCode() == KeyEvent.VK_UNDEFINED ? event.getExtendedKeyCode() : event.getKeyCode();
    }

    private void press(KeyEvent event) {
        int code = event.getKeyCode();
        boolean shift = event.isShiftDown();
        int letter = keyboard.command(LatinKeys.letter(event));
        Vector3dc thrust = letter >= 0 && letter < RideKeyboard.BRAKE
                ? LETTERS.get(letter)
                : (shift ? WITH_SHIFT : ARROWS).get(code);
        if (thrust != null) {
            hold(key(event), thrust);
        } else if (letter == RideKeyboard.BRAKE || shift && code == KeyEvent.VK_SPACE) {
            letGo();
            pilot.brake();
        } else {
            switch (code) {
                case KeyEvent.VK_SPACE -> {
                    letGo();
                    pilot.stopThrust();
                }
                case KeyEvent.VK_HOME -> {
                    letGo();
                    pilot.home();
                }
                case KeyEvent.VK_LEFT -> turn.by(-1, 0);
                case KeyEvent.VK_RIGHT -> turn.by(1, 0);
                case KeyEvent.VK_PAGE_UP -> turn.by(0, 1);
                case KeyEvent.VK_PAGE_DOWN -> turn.by(0, -1);
                default -> {
                    return;
                }
            }
        }
        event.consume();
    }

    private void hold(int key, Vector3dc thrust) {
        Held before = held.get(key);
        if (before != null) {
            before.ending.stop();
            return;
        }
        Timer ending = new Timer(REPEAT_MILLISECONDS, event -> release(key));
        ending.setRepeats(false);
        held.put(key, new Held(thrust, ending));
        pilot.setThrust(thrust());
    }

    private void release(int key) {
        held.remove(key);
        if (pilot.isFlying()) {
            pilot.setThrust(thrust());
        }
    }

    /** Forgets all keys that are held. */
    private void letGo() {
        boolean thrusts = !held.isEmpty();
        held.values().forEach(key -> key.ending.stop());
        held.clear();
        if (thrusts && pilot.isFlying()) {
            pilot.setThrust(new Vector3d());
        }
    }

    private Vector3d thrust() {
        Vector3d sum = new Vector3d();
        held.values().forEach(key -> sum.add(key.thrust));
        return sum;
    }
}
