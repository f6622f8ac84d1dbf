package tompkins.render;

import java.util.concurrent.CancellationException;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Takes complete photographs for files, one after the other. */
public final class PhotographTaker implements AutoCloseable {

    /** Seconds between looks at the progress. */
    private static final double PATIENCE = 0.02;

    private final Renderer renderer;
    private RenderPlan plan;

    /** Takes photographs with one thread for each core. */
    public PhotographTaker() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /** Takes photographs with a number of threads. */
    public PhotographTaker(int threads) {
        renderer = new Renderer(threads);
    }

    /**
     * Takes a photograph, as good as the studio says, and waits for it.
     *
     * @param done the fraction of the task that was done before
     * @param fraction the fraction of the task that the photograph is
     * @return the job that is done
     * @throws CancellationException if the task is cancelled
     */
    public RenderJob take(Studio studio, Progress progress, double done, double fraction) throws InterruptedException {
        // the scene often stays the same from moment to moment of an animation
        plan = RenderPlan.of(studio, plan);
        RenderJob job = renderer.start(plan, Quality.of(studio), RenderListener.NONE);
        while (!job.isComplete() && job.failure() == null) {
            if (progress.isCancelled()) {
                job.cancel();
            }
            progress.requireWanted();
            progress.setProgress(done + fraction * job.progress());
            job.await(PATIENCE);
        }
        job.await();
        return job;
    }

    @Override
    public void close() {
        renderer.close();
    }
}
