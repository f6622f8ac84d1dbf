package tompkins.app;

import java.io.Console;
import java.io.PrintWriter;
import java.util.Locale;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Tile;

/** One line on a terminal that says how far a render is, how fast, and how long it still takes. */
final class ProgressLine implements RenderListener {

    private static final long INTERVAL_NANOS = 200_000_000;
    private static final int WIDTH = 72;

    private final PrintWriter out;
    private final boolean terminal = isTerminal();
    private final long start = System.nanoTime();
    private long last = start;

    ProgressLine(PrintWriter out) {
        this.out = out;
    }

    /** From Java 22 on there is always a console, and it says itself whether somebody watches it. */
    private static boolean isTerminal() {
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

    @Override
    public synchronized void tileDone(RenderJob job, Tile tile) {
        long now = System.nanoTime();
        if (!terminal || now - last < INTERVAL_NANOS) {
            return;
        }
        last = now;
        double progress = job.progress();
        double seconds = (now - start) / 1e9;
        long samples = (long) (progress
                * job.plan().samples()
                * job.plan().width()
                * job.plan().height());
        show(String.format(
                Locale.ROOT,
                "%3.0f %%   %.2f million camera rays/s   %.0f s left",
                100 * progress,
                job.samples() / seconds / 1e6,
                seconds * (1 - progress) / Math.max(progress, 1e-9)));
    }

    /** Takes the line away. */
    synchronized void clear() {
        if (terminal && last != start) {
            show("");
            out.print("\r");
            out.flush();
        }
    }

    private void show(String text) {
        out.print("\r" + text + " ".repeat(Math.max(0, WIDTH - text.length())));
        out.flush();
    }
}
