package tompkins.ui.widget;

import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.util.HashSet;
import java.util.Set;
import javax.swing.SwingUtilities;

/**
 * Faults of the program. They must not stop what is under way; as the handler of unexpected errors on the event thread
 * it tells the user about them, because a program that was started with the mouse has no console.
 */
public final class Faults implements Thread.UncaughtExceptionHandler {

    /** The errors that were reported: an error that occurs whenever the window is painted is reported once. */
    private final Set<String> told = new HashSet<>();

    /** Throws a fault again after what is under way, where nobody but the handler hears it. */
    public static void tell(RuntimeException fault) {
        SwingUtilities.invokeLater(() -> {
            throw fault;
        });
    }

    @Override
    public void uncaughtException(Thread thread, Throwable failure) {
        // to the console, if there is one
        thread.getThreadGroup().uncaughtException(thread, failure);
        String message = Messages.of(failure);
        if (told.add(message)) {
            Window window =
                    KeyboardFocusManager.getCurrentKeyboardFocusManager().getActiveWindow();
            Messages.error(window, Texts.get("message.unexpected", message));
        }
    }
}
