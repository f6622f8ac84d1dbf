package tompkins.app;

import java.io.PrintWriter;
import java.util.Locale;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Tile;

/** One line on a terminal that says how far a render is, how fast, and how long it still takes. */
final class ProgressLine implements RenderListener {

    private static final long INTERVAL_NANOS = 200_000_000;

    private final ConsoleLine line;
    private final long start = System.nanoTime();
    private long last = start;

    ProgressLine(PrintWriter out) {
        line = new ConsoleLine(out);
    }

    @Override
    public synchronized void tileDone(RenderJob job, Tile tile) {
        long now = System.nanoTime();
        if (!line.watched() || now - last < INTERVAL_NANOS) {
            return;
        }
        last = now;
        double progress = job.progress();
        double seconds = (now - start) / 1e9;
        line.show(String.format(
                Locale.ROOT,
                "%3.0f %%   %.2f million camera rays/s   %.0f s left",
                100 * progress,
                job.samples() / seconds / 1e6,
                seconds * (1 - progress) / Math.max(progress, 1e-9)));
    }

    /** Takes the line away. */
    synchronized void clear() {
        line.clear();
    }
}
