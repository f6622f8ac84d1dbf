package tompkins.ui;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.DefaultKeyboardFocusManager;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.WindowEvent;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.LongConsumer;
import tompkins.ui.widget.Look;

/**
 * Lets only these events through, and those of the program, and none of mouse, keys and focus of the screen. The window
 * that asked for the focus or was pressed last has it, whatever the screen and its window manager say.
 */
final class OwnEvents extends EventQueue {

    /** There is one queue for all windows. */
    static final OwnEvents EVENTS = new OwnEvents();

    private final Set<AWTEvent> own = Collections.newSetFromMap(new IdentityHashMap<>());

    /** The windows on the screen, in the order in which they asked for the focus, or were pressed. */
    private final List<Window> opened = new ArrayList<>();

    private final OwnFocus focus = new OwnFocus();
    private boolean installed;
    private boolean looking;
    private boolean giving;
    private FocusEvent.Cause cause = FocusEvent.Cause.UNKNOWN;

    /** Takes the processor time of each event, in nanoseconds. */
    private LongConsumer watcher = time -> {};

    /** Begins to keep from all windows what happens on the screen. */
    synchronized void install() {
        if (!installed) {
            installed = true;
            WindowDriver.onEventThread(() -> {
                KeyboardFocusManager.setCurrentKeyboardFocusManager(focus);
                // the look of a test before this one had told the other one of its keys
                Look.LIGHT.install(1);
                Toolkit.getDefaultToolkit().getSystemEventQueue().push(this);
            });
        }
    }

    /** Gives an event to its component, as if it came from the screen, and waits until it was handled. */
    void give(AWTEvent event) {
        WindowDriver.onEventThread(() -> {
            own.add(event);
            if (event.getID() == KeyEvent.KEY_PRESSED || event.getID() == MouseEvent.MOUSE_PRESSED) {
                cause = causeOfFocus(event);
            }
            postEvent(event);
        });
        // a dialog that it opens waits for its answer: only what comes after it tells that it was handled
        WindowDriver.onEventThread(() -> null);
        WindowDriver.onEventThread(() -> null);
    }

    /** Why the focus moves after a press, if it does: it may come as late as with the release. */
    private static FocusEvent.Cause causeOfFocus(AWTEvent event) {
        if (event instanceof KeyEvent key && key.getKeyCode() == KeyEvent.VK_TAB) {
            return key.isShiftDown() ? FocusEvent.Cause.TRAVERSAL_BACKWARD : FocusEvent.Cause.TRAVERSAL_FORWARD;
        }
        return event instanceof MouseEvent ? FocusEvent.Cause.MOUSE_EVENT : FocusEvent.Cause.UNKNOWN;
    }

    /** Tells of the processor time that the event thread takes for each event from now on, in nanoseconds. */
    void watch(LongConsumer processorTimes) {
        WindowDriver.onEventThread(() -> {
            watcher = processorTimes;
        });
    }

    @Override
    protected void dispatchEvent(AWTEvent event) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long start = threads.getCurrentThreadCpuTime();
        dispatch(event);
        watcher.accept(threads.getCurrentThreadCpuTime() - start);
    }

    private void dispatch(AWTEvent event) {
        if (own.remove(event) || giving || !isOfScreen(event)) {
            super.dispatchEvent(event);
        }
        lookAfterFocus();
    }

    private static boolean isOfScreen(AWTEvent event) {
        return event instanceof InputEvent
                || event.getID() == WindowEvent.WINDOW_GAINED_FOCUS
                || event.getID() == WindowEvent.WINDOW_LOST_FOCUS;
    }

    /** Gives the focus to what wants it, after the program has moved it itself if it could. */
    private void lookAfterFocus() {
        if (!looking && isFocusWrong()) {
            looking = true;
            invokeLater(() -> {
                looking = false;
                giveFocus();
            });
        }
    }

    private void giveFocus() {
        if (isFocusWrong()) {
            giving = true;
            super.dispatchEvent(new FocusEvent(wanted(), FocusEvent.FOCUS_GAINED, false, focus.getFocusOwner(), cause));
            giving = false;
        }
    }

    private boolean isFocusWrong() {
        Component wanted = wanted();
        return wanted != null && wanted != focus.getFocusOwner();
    }

    /** What the window that was opened or pressed last wants to have the focus. */
    private Component wanted() {
        Window window = focused();
        if (window == null) {
            return null;
        }
        Component wanted = focus.wantedIn(window);
        return wanted != null && wanted.isShowing() && wanted.isFocusable() && wanted.isEnabled() ? wanted : null;
    }

    private Window focused() {
        look();
        Window last = null;
        for (Window window : opened) {
            last = window.isFocusableWindow() && !isBlocked(window) ? window : last;
        }
        return last;
    }

    private void look() {
        opened.removeIf(window -> !window.isShowing());
        for (Window window : Window.getWindows()) {
            if (window.isShowing() && !opened.contains(window)) {
                opened.add(window.isAutoRequestFocus() ? opened.size() : 0, window);
            }
        }
    }

    /** Whether a dialog that is not its own has to be answered first. */
    private boolean isBlocked(Window window) {
        return opened.stream()
                .anyMatch(other -> other instanceof Dialog dialog && dialog.isModal() && !isWithin(window, dialog));
    }

    private static boolean isWithin(Window window, Window owner) {
        return window != null && (window == owner || isWithin(window.getOwner(), owner));
    }

    void raise(Window window) {
        WindowDriver.onEventThread(() -> {
            if (opened.remove(window)) {
                opened.add(window);
            }
        });
    }

    /** What a key that is pressed now goes to: the screen may have left the focus nowhere since the last one. */
    Component keyTarget() {
        giveFocus();
        Component owner = focus.getFocusOwner();
        return owner != null ? owner : focused();
    }

    /** The topmost window at a place of the screen. */
    Window windowAt(Point place) {
        look();
        Window top = null;
        for (Window window : opened) {
            boolean above = top == null || !isWithin(top, window);
            if (above && window.getBounds().contains(place) && !isBlocked(window)) {
                top = window;
            }
        }
        return top;
    }

    /** Knows what each window wants to have the focus, also of that which has the keys. */
    private static final class OwnFocus extends DefaultKeyboardFocusManager {

        private boolean asking;

        /** What asked for the focus in a window last, and got it only if the screen allowed. */
        Component wantedIn(Window window) {
            // a window with the keys would name what has the focus
            asking = true;
            Component wanted = window.getMostRecentFocusOwner();
            asking = false;
            return wanted;
        }

        @Override
        protected Window getGlobalFocusedWindow() {
            return asking ? null : super.getGlobalFocusedWindow();
        }
    }
}
