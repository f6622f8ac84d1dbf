package tompkins.study;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Photographs whose times and errors are to be compared. */
final class Photographs {

    private Photographs() {}

    /** A studio with a smaller picture of the same shape. */
    static Studio small(Studio studio, int columns) {
        int rows = Math.max(
                1, columns * studio.settings().height() / studio.settings().width());
        return studio.withSettings(studio.settings().withSize(columns, rows));
    }

    /**
     * Takes a photograph with one thread.
     *
     * @throws CancellationException soon after {@code cancelled} became true
     */
    static RenderJob taken(RenderPlan plan, Quality quality, BooleanSupplier cancelled) {
        RenderListener canceller = new RenderListener() {
            @Override
            public void tileDone(RenderJob job) {
                if (cancelled.getAsBoolean()) {
                    job.cancel();
                }
            }
        };
        try (Renderer renderer = new Renderer(1)) {
            RenderJob job = renderer.start(plan, quality, canceller);
            job.await();
            if (!job.isComplete()) {
                throw new CancellationException();
            }
            return job;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
    }
}
