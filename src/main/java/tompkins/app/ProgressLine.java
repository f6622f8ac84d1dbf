package tompkins.app;

import java.io.Console;
import java.io.PrintWriter;
import java.util.Locale;
import tompkins.render.Progress;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;

/** One line on a terminal that says what is being done, how far a picture or an animation is, and how long it takes. */
final class ProgressLine implements RenderListener, Progress {

    private static final long INTERVAL_NANOS = 200_000_000;
    private static final int WIDTH = 72;

    private final PrintWriter out;
    private final boolean watched = isWatched();
    private boolean written;
    private long start = System.nanoTime();
    private long last = start;

    ProgressLine(PrintWriter out) {
        this.out = out;
    }

    /** Since Java 22 there is always a console, which says itself whether it is a terminal. */
    @SuppressWarnings("SystemConsoleNull")
    static boolean isWatched() {
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

    /** Writes over what the line says. Nothing is written if the output is not a terminal. */
    private void show(String text) {
        if (watched) {
            out.print("\r" + text + " ".repeat(Math.max(0, WIDTH - text.length())));
            out.flush();
            written = true;
        }
    }

    /** Says at once what is being done; the time that is left counts from here. */
    synchronized void begin(String doing) {
        start = System.nanoTime();
        last = start;
        show(doing);
    }

    @Override
    public synchronized void tileDone(RenderJob job) {
        setProgress(job.progress());
    }

    @Override
    public synchronized void setProgress(double share) {
        long now = System.nanoTime();
        if (watched && now - last >= INTERVAL_NANOS) {
            last = now;
            double left = (now - start) / 1e9 * (1 - share) / Math.max(share, 1e-9);
            show(String.format(Locale.ROOT, "%3.0f %%   %.0f s left", 100 * share, left));
        }
    }

    @Override
    public boolean isCancelled() {
        return false;
    }

    /** Removes what a terminal shows. */
    synchronized void clear() {
        if (written) {
            show("");
            out.print("\r");
            out.flush();
            written = false;
        }
    }
}
