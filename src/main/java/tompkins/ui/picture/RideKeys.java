package tompkins.ui.picture;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import javax.swing.Timer;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The keys of a ride on a canvas: those that are held down give thrust. Some displays repeat a key that is held by
 * releasing it for a moment each time; only a key that stays released counts.
 */
public final class RideKeys {

    /** What the keys of a ride do. */
    public interface Pilot {

        /** Whether the keys are those of a ride now. */
        boolean isFlying();

        /** Thrusts from now on, to the right, up and forwards; not at all if it is zero. */
        void thrust(Vector3dc direction);

        /** Ends the thrust. */
        void stop();

        /** Brakes to rest. */
        void brake();

        /** Turns the view, by steps to the right and up. */
        void turn(int right, int up);
    }

    private static final int REPEAT_MILLISECONDS = 20;

    private static final Map<Integer, Vector3dc> THRUST = Map.of(
            KeyEvent.VK_W, new Vector3d(0, 0, 1),
            KeyEvent.VK_UP, new Vector3d(0, 0, 1),
            KeyEvent.VK_S, new Vector3d(0, 0, -1),
            KeyEvent.VK_DOWN, new Vector3d(0, 0, -1),
            KeyEvent.VK_A, new Vector3d(-1, 0, 0),
            KeyEvent.VK_D, new Vector3d(1, 0, 0),
            KeyEvent.VK_Q, new Vector3d(0, -1, 0),
            KeyEvent.VK_E, new Vector3d(0, 1, 0));

    private final Pilot pilot;
    private final Map<Integer, Timer> held = new HashMap<>();

    /** Listens to the keys of a canvas. */
    public RideKeys(PictureCanvas canvas, Pilot pilot) {
        this.pilot = pilot;
        canvas.addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent event) {
                if (pilot.isFlying() && event.getModifiersEx() == 0) {
                    press(event);
                }
            }

            @Override
            public void keyReleased(KeyEvent event) {
                Timer ending = held.get(event.getKeyCode());
                if (ending != null) {
                    ending.restart();
                }
            }

            @Override
            public void keyTyped(KeyEvent event) {
                // letters of a ride mean nothing else
                if (pilot.isFlying() && event.getModifiersEx() == 0) {
                    event.consume();
                }
            }
        });
        canvas.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                letGo();
            }
        });
    }

    private void press(KeyEvent event) {
        int code = event.getKeyCode();
        if (THRUST.containsKey(code)) {
            hold(code);
        } else {
            switch (code) {
                case KeyEvent.VK_SPACE -> {
                    letGo();
                    pilot.stop();
                }
                case KeyEvent.VK_B -> {
                    letGo();
                    pilot.brake();
                }
                case KeyEvent.VK_LEFT -> pilot.turn(-1, 0);
                case KeyEvent.VK_RIGHT -> pilot.turn(1, 0);
                case KeyEvent.VK_PAGE_UP -> pilot.turn(0, 1);
                case KeyEvent.VK_PAGE_DOWN -> pilot.turn(0, -1);
                default -> {
                    return;
                }
            }
        }
        event.consume();
    }

    private void hold(int code) {
        Timer ending = held.get(code);
        if (ending != null) {
            ending.stop();
            return;
        }
        ending = new Timer(REPEAT_MILLISECONDS, event -> release(code));
        ending.setRepeats(false);
        held.put(code, ending);
        pilot.thrust(thrust());
    }

    private void release(int code) {
        held.remove(code);
        if (pilot.isFlying()) {
            pilot.thrust(thrust());
        }
    }

    /** Forgets all keys that are held. */
    private void letGo() {
        boolean thrusts = !held.isEmpty();
        held.values().forEach(Timer::stop);
        held.clear();
        if (thrusts && pilot.isFlying()) {
            pilot.thrust(new Vector3d());
        }
    }

    private Vector3d thrust() {
        Vector3d sum = new Vector3d();
        held.keySet().forEach(code -> sum.add(THRUST.get(code)));
        return sum;
    }
}
