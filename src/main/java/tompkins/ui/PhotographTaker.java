package tompkins.ui;

import java.util.concurrent.CancellationException;
import tompkins.image.LinearImage;
import tompkins.image.PhotographInfo;
import tompkins.io.StudioWriter;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Takes complete photographs for files, apart from the one on the screen. */
final class PhotographTaker implements AutoCloseable {

    private static final int POLL_MILLISECONDS = 20;

    private final Renderer renderer = new Renderer();

    /**
     * Takes a photograph and waits for it.
     *
     * @param done the share of the task that was done before
     * @param share the share of the task that the photograph is
     * @throws CancellationException if the task is cancelled
     */
    LinearImage take(Studio studio, Progress progress, double done, double share) throws InterruptedException {
        RenderJob job = renderer.start(RenderPlan.of(studio), RenderListener.NONE);
        while (!job.isComplete() && job.failure() == null) {
            if (progress.isCancelled()) {
                job.cancel();
                throw new CancellationException();
            }
            progress.setProgress(done + share * job.progress());
            Thread.sleep(POLL_MILLISECONDS);
        }
        job.await();
        return job.image();
    }

    /**
     * What the file of a studio's photograph says about itself.
     *
     * @throws tompkins.property.InvalidPropertyException if the scene is too long to travel inside
     */
    static PhotographInfo info(Studio studio) {
        String title = studio.title().replaceAll("\\p{Cntrl}", " ");
        return new PhotographInfo(title, "Tompkins", StudioWriter.writeSelfContained(studio));
    }

    @Override
    public void close() {
        renderer.close();
    }
}
