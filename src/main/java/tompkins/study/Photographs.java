package tompkins.study;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import tompkins.image.LinearImage;
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
        RenderJob job = done(renderer -> renderer.start(plan, quality, canceller));
        if (!job.isComplete()) {
            throw new CancellationException();
        }
        return job;
    }

    /** Renders with one thread, and waits for it. */
    static RenderJob done(Function<Renderer, RenderJob> start) {
        try (Renderer renderer = new Renderer(1)) {
            RenderJob job = start.apply(renderer);
            job.await();
            return job;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
    }

    /** The light of all pixels, three channels each. */
    static double[] light(LinearImage image) {
        float[] rgb = image.rgb();
        double[] light = new double[rgb.length];
        for (int i = 0; i < light.length; i++) {
            light[i] = rgb[i];
        }
        return light;
    }
}
