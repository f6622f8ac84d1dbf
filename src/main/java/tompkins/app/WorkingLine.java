package tompkins.app;

import java.io.PrintStream;

/**
 * Says that a command still works if it prints nothing for a while: on a terminal in a line that counts the seconds and
 * goes when something is printed, elsewhere once.
 */
final class WorkingLine {

    /** What is printed then. */
    static final String NOTE = "note: this takes a while; Ctrl-C stops it";

    private static final long SECOND = 1000;

    /** Seconds until it is printed where nobody sees a line come and go. */
    private static final int PATIENCE = 2;

    private final PrintStream err;
    private final boolean watched;
    private int seconds;
    private String shown = "";

    /**
     * A line that is not shown yet.
     *
     * @param err where it is shown
     * @param watched whether that is a terminal
     */
    WorkingLine(PrintStream err, boolean watched) {
        this.err = err;
        this.watched = watched;
    }

    /** Counts the seconds from now on, until the program ends. */
    void start() {
        Thread clock = new Thread(this::count, "tompkins-working");
        clock.setDaemon(true);
        clock.start();
    }

    private void count() {
        try {
            while (true) {
                Thread.sleep(SECOND);
                secondPassed();
            }
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }

    /** Shows how long the command has worked. */
    synchronized void secondPassed() {
        seconds++;
        if (watched) {
            clear();
            shown = "working for " + seconds + " s; Ctrl-C stops it";
            err.print(shown);
            err.flush();
        } else if (seconds == PATIENCE) {
            err.println(NOTE);
        }
    }

    /** Removes the line, for something that is printed while the lock of this object is held. */
    synchronized void clear() {
        if (!shown.isEmpty()) {
            err.print("\r" + " ".repeat(shown.length()) + "\r");
            err.flush();
            shown = "";
        }
    }
}
