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

/** Knows whether a button of the mouse is down anywhere in the windows, and lets actions wait for its end. */
public final class MousePress {

    private static final int BUTTONS =
            InputEvent.BUTTON1_DOWN_MASK | InputEvent.BUTTON2_DOWN_MASK | InputEvent.BUTTON3_DOWN_MASK;

    /** There is one mouse for all windows. */
    private static final MousePress MOUSE = new MousePress();

    private final List<Consumer<Component>> watchers = new ArrayList<>();
    private final List<Runnable> waiting = new ArrayList<>();
    private boolean down;

    private MousePress() {
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(this::note, AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
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
