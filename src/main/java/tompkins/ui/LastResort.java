package tompkins.ui;

import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.util.HashSet;
import java.util.Set;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/**
 * Tells the user of what went wrong on the event thread and nobody expected: a program that was started with the mouse
 * has no console to tell it.
 */
final class LastResort implements Thread.UncaughtExceptionHandler {

    /** What was told: what fails whenever the window is painted is told once. */
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
