package tompkins.app;

import java.io.Console;
import java.io.PrintWriter;

/** One line of a terminal that is written again and again. Nothing is written if the output is not a terminal. */
final class ConsoleLine {

    private static final int WIDTH = 72;

    private final PrintWriter out;
    private final boolean watched = isWatched();
    private boolean written;

    ConsoleLine(PrintWriter out) {
        this.out = out;
    }

    /** Since Java 22 there is always a console, which says itself whether it is a terminal. */
    @SuppressWarnings("SystemConsoleNull")
    private static boolean isWatched() {
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            return (boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException beforeJava22) {
            return true;
        }
    }

    /** Whether there is a terminal. */
    boolean watched() {
        return watched;
    }

    /** Shows a text instead of the one before. */
    void show(String text) {
        if (watched) {
            out.print("\r" + text + " ".repeat(Math.max(0, WIDTH - text.length())));
            out.flush();
            written = true;
        }
    }

    /** Removes the line, if there is one. */
    void clear() {
        if (written) {
            show("");
            out.print("\r");
            out.flush();
            written = false;
        }
    }
}
