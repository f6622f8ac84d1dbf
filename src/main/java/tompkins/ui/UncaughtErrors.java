package tompkins.ui;

import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.util.HashSet;
import java.util.Set;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/**
 * Tells the user about unexpected errors on the event thread, because a program that was started with the mouse has no
 * console.
 */
final class UncaughtErrors implements Thread.UncaughtExceptionHandler {

    /** The errors that were reported: an error that occurs whenever the window is painted is reported once. */
    private final Set<String> told = new HashSet<>();

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
