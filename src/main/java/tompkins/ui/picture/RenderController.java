package tompkins.ui.picture;

import java.awt.Dimension;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.RenderReport;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.ui.model.Pace;

/**
 * Makes the picture of the newest studio, away from the event thread. While a slider is dragged, or an animation runs,
 * each picture gets as far as its {@link Pace} allows, and is then replaced by the next one; when nothing changes any
 * more the picture is completed.
 */
public final class RenderController implements AutoCloseable {

    /**
     * A picture that has nothing to show after this time is replaced all the same. The next one gets twice the time, so
     * that something is seen at last.
     */
    private static final Duration LONGEST_WAIT = Duration.ofMillis(80);

    /** Nobody waits longer for the plan of what has been changed since. */
    private static final Duration LONGEST_OVERTAKEN = Duration.ofSeconds(1);

    /** A picture that takes less time tells its error only when it is complete: nobody would read it before. */
    private static final Duration READABLE = Duration.ofMillis(500);

    /** The sum of the parts of the work may miss 1 by its rounding. */
    private static final double ALMOST_ONE = 1 - 1e-9;

    /** A studio, how large its picture is to be, and since when it is wanted. */
    private record Request(Studio studio, Dimension size, Pace pace, long time) {

        Studio inSize() {
            return studio.withSettings(studio.settings().withSize(size.width, size.height));
        }
    }

    private final Renderer renderer = new Renderer();
    private final Consumer<Picture> pictures;
    private final Consumer<Throwable> failures;
    private final Asker planner;

    /**
     * The picture that is wanted; null when it is there, cannot be made, or was stopped, even if it is still being
     * planned.
     */
    private final AtomicReference<Request> wanted = new AtomicReference<>();

    private volatile boolean stopped;
    private volatile Run run;

    private final Object shownLock = new Object();
    private int lastShown;

    // used by the planner's thread only
    private int runs;
    private RenderPlan lastPlan;
    private long longestWait = LONGEST_WAIT.toNanos();

    /**
     * A controller.
     *
     * @param pictures notified of each better picture, by threads of the renderer
     * @param failures notified of why there is no picture, by threads of the renderer and the controller
     */
    public RenderController(Consumer<Picture> pictures, Consumer<Throwable> failures) {
        this.pictures = pictures;
        this.failures = failures;
        planner = new Asker("tompkins-plan", failures);
    }

    /**
     * Asks for the picture of a studio, in some size, instead of all pictures that were asked for before. Returns at
     * once.
     */
    public void show(Studio studio, Dimension size, Pace pace) {
        Request request = new Request(studio, size, pace, System.nanoTime());
        stopped = false;
        wanted.set(request);
        planner.submit(() -> render(request), error -> fail(request, error));
        Run running = run;
        if (pace == Pace.ANSWER && running != null && running.request.pace == Pace.RIDE) {
            running.job.cancel();
            running.tellWaiting();
        }
    }

    /** Ends the work on the picture; what is there stays. */
    public void stop() {
        if (wanted.getAndSet(null) != null) {
            stopped = true;
        }
        Run running = run;
        if (running != null) {
            running.job.cancel();
        }
    }

    /** Whether the last picture that was asked for was stopped before it was complete. */
    public boolean isStopped() {
        return stopped;
    }

    /** Whether a picture is wanted, or the renderer still works on one that was stopped. */
    public boolean isBusy() {
        Run running = run;
        return wanted.get() != null || running != null && !running.ended;
    }

    /** The share of the wanted picture that is done, from 0 to 1; 1 if none is wanted. */
    public double progress() {
        Request request = wanted.get();
        if (request == null) {
            return 1;
        }
        Run running = run;
        return running != null && running.request == request ? running.job.progress() : 0;
    }

    private void render(Request request) {
        giveWay();
        if (wanted.get() != request) {
            return;
        }
        long begun = System.nanoTime();
        // while only the camera changes, the prepared scene is used again
        RenderPlan plan = RenderPlan.of(request.inSize(), lastPlan);
        lastPlan = plan;
        if (isGivenUp(request, begun)) {
            return;
        }
        Run next = new Run(request);
        next.job = request.pace.isGlimpse()
                ? renderer.startGlimpse(plan, request.pace.glimpseSeconds(), next)
                : renderer.startCoarse(plan, Quality.of(request.studio), next);
        run = next;
        if (wanted.get() == null) {
            // it may have been stopped too early for the run to be seen
            next.job.cancel();
        }
    }

    /**
     * Whether a picture is given up whose plan was begun at a time. A dragging hand asks for the next one within
     * milliseconds: if each gave way at once, a scene that takes long to plan would show none until the hand rests.
     */
    private boolean isGivenUp(Request request, long begun) {
        Request newest = wanted.get();
        if (newest == null || newest == request) {
            return newest == null;
        }
        return request.pace.isGlimpse() || System.nanoTime() - begun > LONGEST_OVERTAKEN.toNanos();
    }

    /** Tells why there is no picture, unless it is no longer wanted. */
    private void fail(Request request, Throwable error) {
        if (wanted.compareAndSet(request, null)) {
            failures.accept(error);
        }
    }

    /** Ends the running picture as soon as it has been shown for long enough. */
    private void giveWay() {
        Run running = run;
        if (running == null || running.job.isCancelled()) {
            return;
        }
        running.awaitChance(longestWait);
        boolean hadChance = running.shown || running.ended || running.job.isCancelled();
        longestWait = hadChance ? LONGEST_WAIT.toNanos() : 2 * longestWait;
        running.job.cancel();
    }

    @Override
    public void close() {
        planner.close();
        stop();
        renderer.close();
    }

    /** One picture that is being rendered. */
    private final class Run implements RenderListener {

        private final Request request;
        private final int number = ++runs;
        private final long startTime = System.nanoTime();
        private volatile RenderJob job;
        private volatile boolean shown;
        private volatile boolean ended;

        Run(Request request) {
            this.request = request;
        }

        /** Waits until the next picture may replace this one. */
        synchronized void awaitChance(long longestWait) {
            try {
                for (long left = left(longestWait); left > 0; left = left(longestWait)) {
                    TimeUnit.NANOSECONDS.timedWait(this, left);
                }
            } catch (InterruptedException closing) {
                Thread.currentThread().interrupt();
            }
        }

        /** How many nanoseconds it may still take, as things stand. */
        private long left(long longestWait) {
            long all = shown ? request.pace.frame() : Math.max(longestWait, request.pace.shortestChance());
            return ended || job.isCancelled() ? 0 : all - (System.nanoTime() - startTime);
        }

        private synchronized void tellWaiting() {
            notifyAll();
        }

        @Override
        public void passDone(RenderJob rendered) {
            if (request.pace.isGlimpse()) {
                return;
            }
            long now = System.nanoTime();
            // each coarse pass takes three times as many samples as all passes before it
            long nextPass = now - request.time + 3 * (now - startTime);
            boolean finerSoon = !shown && request.pace.waits(samples(rendered), nextPass);
            boolean last = rendered.progress() > ALMOST_ONE;
            if (!finerSoon && !last && !rendered.isCancelled()) {
                deliver(rendered, false);
            }
        }

        @Override
        public void ended(RenderJob rendered) {
            // a glimpse is put together before the next one takes the processors
            ended = !request.pace.isGlimpse();
            if (rendered.failure() != null) {
                fail(request, rendered.failure());
            } else if (rendered.isComplete()) {
                deliverLast(rendered, wanted.compareAndSet(request, null));
            }
            ended = true;
            tellWaiting();
        }

        /** Delivers the last image, for which there may be no memory, because it is the largest. */
        private void deliverLast(RenderJob rendered, boolean wasWanted) {
            try {
                deliver(rendered, !request.pace.isGlimpse());
            } catch (RuntimeException | Error error) {
                if (wasWanted) {
                    failures.accept(error);
                }
            }
        }

        private static double samples(RenderJob rendered) {
            return (double) rendered.samples()
                    / rendered.plan().studio().settings().pixels();
        }

        private static Picture.Flaw flaw(RenderReport report) {
            return report.missesScene()
                    ? Picture.Flaw.EMPTY
                    : report.isBurnt() ? Picture.Flaw.BURNT : Picture.Flaw.NONE;
        }

        private LinearImage light(RenderJob rendered, boolean complete) {
            if (request.pace.isGlimpse()) {
                return null;
            }
            return complete ? rendered.image() : rendered.preview(Quality.of(request.studio));
        }

        private void deliver(RenderJob rendered, boolean complete) {
            Duration time = Duration.ofNanos(System.nanoTime() - request.time);
            // the error takes a moment to work out, in which no samples are taken
            boolean tellsError =
                    complete || System.nanoTime() - startTime > READABLE.toNanos() && !request.pace.isGlimpse();
            RenderReport report = tellsError ? rendered.report() : null;
            Picture picture = new Picture(
                    request.studio,
                    rendered.plan(),
                    light(rendered, complete),
                    request.pace.isGlimpse() ? rendered.levels().image() : null,
                    complete,
                    time,
                    samples(rendered),
                    tellsError ? report.error() : Double.NaN,
                    complete ? report.warnings() : List.of(),
                    complete ? flaw(report) : Picture.Flaw.NONE);
            synchronized (shownLock) {
                // a newer picture may have been faster
                if (number >= lastShown) {
                    lastShown = number;
                    pictures.accept(picture);
                }
            }
            shown = true;
            tellWaiting();
        }
    }
}
