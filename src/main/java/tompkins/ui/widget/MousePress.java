package tompkins.ui.widget;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/**
 * Knows whether a button of the mouse is down anywhere in the windows, lets actions wait for its end, and ends drags.
 */
public final class MousePress {

    private static final int BUTTONS =
            InputEvent.BUTTON1_DOWN_MASK | InputEvent.BUTTON2_DOWN_MASK | InputEvent.BUTTON3_DOWN_MASK;

    /** There is one mouse for all windows. */
    private static final MousePress MOUSE = new MousePress();

    private final List<Consumer<Component>> watchers = new ArrayList<>();
    private final List<Runnable> waiting = new ArrayList<>();
    private boolean down;

    /** The last event of a drag that goes on; null if none does, or if it was ended before its button came up. */
    private MouseEvent drag;

    private boolean ended;

    private MousePress() {
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(this::note, AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
    }

    /** Whether something is dragged. */
    public static boolean isDragging() {
        return MOUSE.drag != null;
    }

    /** Ends a drag that goes on as if its button had been let go, but never as a click. */
    public static void endDrag() {
        MouseEvent last = MOUSE.drag;
        last.getComponent()
                .dispatchEvent(new MouseEvent(
                        last.getComponent(),
                        MouseEvent.MOUSE_RELEASED,
                        last.getWhen(),
                        0,
                        last.getX(),
                        last.getY(),
                        1,
                        false,
                        MouseEvent.NOBUTTON));
        MOUSE.ended = true;
    }

    /** Tells of every press, before the component under the mouse and the focus are told. */
    static void watch(Consumer<Component> watcher) {
        MOUSE.watchers.add(watcher);
    }

    /** Does something now, or after the present press is over and its click has been handled. */
    static void afterwards(Runnable step) {
        if (MOUSE.down) {
            MOUSE.waiting.add(step);
        } else {
            step.run();
        }
    }

    private void note(AWTEvent event) {
        if (event instanceof MouseEvent mouse) {
            // the state in any event, because some releases are not reported
            down = (mouse.getModifiersEx() & BUTTONS) != 0;
            ended &= down;
            drag = !down || ended ? null : event.getID() == MouseEvent.MOUSE_DRAGGED ? mouse : drag;
            if (event.getID() == MouseEvent.MOUSE_PRESSED) {
                watchers.forEach(watcher -> watcher.accept(mouse.getComponent()));
            }
            if (!down && !waiting.isEmpty()) {
                List<Runnable> steps = List.copyOf(waiting);
                waiting.clear();
                SwingUtilities.invokeLater(() -> steps.forEach(Runnable::run));
            }
        }
    }
}
