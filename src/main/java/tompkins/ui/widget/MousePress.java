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

/** Whether a button of the mouse is down anywhere in the windows, and what has to wait until it is not. */
final class MousePress {

    private static final int BUTTONS =
            InputEvent.BUTTON1_DOWN_MASK | InputEvent.BUTTON2_DOWN_MASK | InputEvent.BUTTON3_DOWN_MASK;

    /** There is one mouse for all windows. */
    private static final MousePress MOUSE = new MousePress();

    private final List<Consumer<Component>> watchers = new ArrayList<>();
    private final List<Runnable> waiting = new ArrayList<>();
    private boolean down;

    private MousePress() {
        Toolkit.getDefaultToolkit().addAWTEventListener(this::note, AWTEvent.MOUSE_EVENT_MASK);
    }

    /** Tells of every press, before the component under the mouse and the focus learn of it. */
    static void watch(Consumer<Component> watcher) {
        MOUSE.watchers.add(watcher);
    }

    /** Does something now, or when the press that goes on is over and what was pressed has had its click. */
    static void afterwards(Runnable step) {
        if (MOUSE.down) {
            MOUSE.waiting.add(step);
        } else {
            step.run();
        }
    }

    private void note(AWTEvent event) {
        if (event instanceof MouseEvent mouse) {
            // that of any event, for some releases are told to nobody
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
