package tompkins.app;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.Supplier;
import tompkins.render.RenderJob;
import tompkins.study.Measurement;
import tompkins.study.StudyKind;

/** One line on a terminal that says what is being done, how far a picture or an animation is, and how long it takes. */
final class ProgressLine extends ProgressReport {

    private static final long INTERVAL_NANOS = 200_000_000;

    private final ConsoleLine line;
    private long start = System.nanoTime();
    private long last = start;

    ProgressLine(PrintWriter out) {
        line = new ConsoleLine(out);
    }

    @Override
    boolean watched() {
        return line.watched();
    }

    @Override
    synchronized void begin(String doing) {
        start = System.nanoTime();
        last = start;
        line.show(doing);
    }

    @Override
    public synchronized void tileDone(RenderJob job) {
        show(
                job.progress(),
                () -> String.format(Locale.ROOT, "%.2f million camera rays/s   ", job.samples() / seconds() / 1e6));
    }

    @Override
    public synchronized void setProgress(double share) {
        show(share, () -> "");
    }

    private void show(double progress, Supplier<String> speed) {
        long now = System.nanoTime();
        if (line.watched() && now - last >= INTERVAL_NANOS) {
            last = now;
            double left = seconds() * (1 - progress) / Math.max(progress, 1e-9);
            line.show(String.format(Locale.ROOT, "%3.0f %%   %s%.0f s left", 100 * progress, speed.get(), left));
        }
    }

    private double seconds() {
        return (System.nanoTime() - start) / 1e9;
    }

    @Override
    synchronized void measured(StudyKind kind, Measurement point, int done, int count) {
        line.show(String.format(
                Locale.ROOT,
                "%s %d/%d: %s, %s, %.6g",
                kind,
                done,
                count,
                point.problem(),
                point.method(),
                point.setting()));
    }

    @Override
    synchronized void clear() {
        line.clear();
    }
}
