package tompkins.render;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tompkins.camera.EyeView;
import tompkins.camera.SamplePositions;
import tompkins.image.FramePicture;
import tompkins.image.LinearImage;
import tompkins.light.ColourLaw;
import tompkins.ray.Padded;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.studio.Studio;
import tompkins.trace.BlockSamples;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/**
 * One picture that is being rendered. The threads of the renderer take tiles from one counter, pass by pass; a thread
 * that finds the pass used up waits for the others, so that each pass is complete before the next begins.
 */
public final class RenderJob extends Padded {

    /** Larger pictures are shown with their noise: to filter takes 44 bytes a pixel for a moment. */
    private static final int MOST_FILTERED = 4_000_000;

    private final RenderPlan plan;
    private final Schedule schedule;
    private final List<Pass> passes = new ArrayList<>();
    private final List<Tile> tiles;
    private final long pixels;
    private final RenderListener listener;
    private final Consumer<RenderJob> whenEnded;
    private final PixelBuffer buffer;
    private final int workers;
    private final long startTime = System.nanoTime();

    private final AtomicInteger nextTile = new AtomicInteger();
    private final AtomicInteger tilesDone = new AtomicInteger();
    private final AtomicInteger workersEnded = new AtomicInteger();
    private final LongAdder samples = new LongAdder();
    private final CountDownLatch end = new CountDownLatch(1);
    private final AtomicReference<RenderFailedException> failure = new AtomicReference<>();
    private final Object passLock = new Object();
    private final RayCounts counts = new RayCounts();

    /** Whether the job was cancelled or has failed; one value, since it is asked for each ray. */
    private volatile boolean stopped;

    private volatile boolean complete;
    private volatile long endTime;
    private final LongAdder planningTime = new LongAdder();

    RenderJob(
            RenderPlan plan,
            Schedule schedule,
            PixelBuffer buffer,
            List<Tile> tiles,
            int workers,
            RenderListener listener,
            Consumer<RenderJob> whenEnded) {
        this.plan = plan;
        this.schedule = schedule;
        this.buffer = buffer;
        this.workers = workers;
        this.listener = listener;
        this.whenEnded = whenEnded;
        this.tiles = tiles;
        pixels = tiles.stream().mapToLong(Tile::pixels).sum();
        passes.add(schedule.next(this::isStopped));
    }

    /** What one thread does for this job. What goes wrong is kept, so that nobody waits for a thread that ended. */
    void work() {
        RayCounts mine = new RayCounts();
        try {
            renderTiles(plan.tracer(mine), mine);
        } catch (RuntimeException | Error error) {
            fail(new RenderFailedException(error));
        } finally {
            workerEnded(mine);
        }
    }

    private void renderTiles(SampleTracer tracer, RayCounts mine) {
        BlockSums sums = new BlockSums(buffer, plan.pictureRays());
        int index = nextTile.getAndIncrement();
        for (Pass pass = passOf(index); pass != null; pass = passOf(index)) {
            Tile tile = tiles.get(index % tiles.size());
            long before = mine.samples;
            renderTile(pass, tile, tracer, sums);
            samples.add(mine.samples - before);
            if (!isStopped()) {
                tileDone();
            }
            index = nextTile.getAndIncrement();
        }
    }

    private void renderTile(Pass pass, Tile tile, SampleTracer tracer, BlockSums sums) {
        tracer.shareBetween(pass.inAll());
        for (Tile block : tile.parts(RayPacket.SIDE * pass.stride())) {
            if (!schedule.isOver() && isWanted(pass, block)) {
                for (EyeView eye : plan.pictureRays().views()) {
                    SamplePositions pixels = sums.begin(pass, eye, block);
                    if (pixels.count() > 0) {
                        renderBlock(pass, pixels, tracer, sums);
                    }
                }
            }
        }
    }

    private void renderBlock(Pass pass, SamplePositions pixels, SampleTracer tracer, BlockSums sums) {
        int end = pass.firstSample() + pass.samples();
        for (int sample = pass.firstSample(); sample < end && !isStopped(); sample++) {
            try {
                BlockSamples taken = tracer.sampleBlock(pixels, sample, this::isStopped);
                if (taken != null) {
                    sums.add(taken);
                }
            } catch (RuntimeException | Error error) {
                fail(new RenderFailedException(tracer.column(), tracer.row(), Math.max(0, sample), error));
            }
            if (Film.isNewHalf(sample + 1)) {
                sums.addToFilm();
            }
        }
        sums.addToFilm();
    }

    private boolean isWanted(Pass pass, Tile block) {
        for (int row = block.row(); row < block.row() + block.height(); row += pass.stride()) {
            if (pass.takesAny(buffer.pixel(block.column(), row), block.width())) {
                return true;
            }
        }
        return false;
    }

    private void tileDone() {
        listener.tileDone(this);
        if (tilesDone.incrementAndGet() % tiles.size() == 0) {
            // before the others continue, so that nothing is added to the film while the listener looks at it
            listener.passDone(this);
            long start = System.nanoTime();
            Pass next;
            try {
                next = schedule.next(this::isStopped);
            } catch (CancellationException stopped) {
                return;
            } finally {
                planningTime.add(System.nanoTime() - start);
            }
            synchronized (passLock) {
                if (next == null) {
                    complete = true;
                } else {
                    passes.add(next);
                }
                passLock.notifyAll();
            }
        }
    }

    /** The pass to which a tile belongs, once those before it are complete; null if the job has come to its end. */
    private Pass passOf(int index) {
        int pass = index / tiles.size();
        synchronized (passLock) {
            while (passes.size() <= pass && !complete && !isStopped()) {
                try {
                    passLock.wait(10);
                } catch (InterruptedException closing) {
                    stopped = true;
                    Thread.currentThread().interrupt();
                }
            }
            return isStopped() || complete ? null : passes.get(pass);
        }
    }

    private void workerEnded(RayCounts mine) {
        synchronized (counts) {
            counts.add(mine);
        }
        if (workersEnded.incrementAndGet() == workers) {
            endTime = System.nanoTime();
            end.countDown();
            try {
                listener.ended(this);
            } finally {
                whenEnded.accept(this);
            }
        }
    }

    private void fail(RenderFailedException why) {
        failure.compareAndSet(null, why);
        stopped = true;
    }

    private boolean isStopped() {
        return stopped;
    }

    /** Ends the job soon: within one sample of each thread. */
    public void cancel() {
        stopped = true;
    }

    /** Whether the job was cancelled before it was complete. */
    public boolean isCancelled() {
        return stopped && failure.get() == null && !complete;
    }

    /** Whether all samples were taken. */
    public boolean isComplete() {
        return complete;
    }

    /** The fraction of the work that is done, from 0 to 1. */
    public double progress() {
        return isComplete() ? 1 : Math.min(1, schedule.progress((double) samples() / pixels));
    }

    /** How many samples were taken so far, without those of the tiles at work. */
    public long samples() {
        return samples.sum();
    }

    /**
     * Waits for the end of the job.
     *
     * @throws RenderFailedException if a sample failed
     */
    public void await() throws InterruptedException {
        end.await();
        if (failure.get() != null) {
            throw failure.get();
        }
    }

    /** Waits for the end of the job, but no longer than some seconds. */
    public void await(double seconds) throws InterruptedException {
        end.await((long) (seconds * 1e9), TimeUnit.NANOSECONDS);
    }

    /** Seconds between the passes, in which the next one was planned. */
    double planningSeconds() {
        return planningTime.sum() / 1e9;
    }

    /** The first sample that failed, or null. */
    public RenderFailedException failure() {
        return failure.get();
    }

    /** The picture so far, in linear light, exposed; a glimpse without stars has its {@link #levels} alone. */
    public LinearImage image() {
        return ((Film) buffer).image();
    }

    /** The picture so far as the screen shows it. */
    public FramePicture levels() {
        return buffer instanceof PreviewFilm preview
                ? preview.levels()
                : FramePicture.of(image(), plan.studio().settings().toneCurve());
    }

    /**
     * As {@link #image}, to be looked at until the picture has a quality. A blur is without the noise of few samples,
     * unless the picture has them all, or will stay as noisy.
     */
    public LinearImage preview(Quality aim) {
        boolean staysNoisy = aim instanceof Quality.Samples all
                && all.samples() < Math.max(AdaptiveSchedule.FIRST_SAMPLES, buffer.samples(0) + 1);
        boolean isFiltered = plan.blurs() && !staysNoisy && buffer.pixels() <= MOST_FILTERED;
        Film film = (Film) buffer;
        return isFiltered && film.comparesSamples() ? NoiseFilter.image(film) : film.image();
    }

    /** The plan of the picture. */
    public RenderPlan plan() {
        return plan;
    }

    /**
     * What was done; complete once the job has ended. Works out the error of the picture, if it is still wanted, which
     * takes a moment. A glimpse without stars has no report.
     */
    public RenderReport report() {
        return report(this::image);
    }

    /** As above, with the picture if it is there already, which would take as much memory again. */
    public RenderReport report(Supplier<LinearImage> image) {
        long until = end.getCount() == 0 ? endTime : System.nanoTime();
        int sampledPixels = buffer.sampledPixels();
        double error = PixelVariance.estimatedError((Film) buffer, sampledPixels, plan, this::isCancelled);
        RayCounts now = new RayCounts();
        synchronized (counts) {
            now.add(counts);
        }
        boolean missesScene = complete && now.sceneHits == 0 && plan.world().hasObjects();
        return new RenderReport(
                now,
                missesScene,
                complete && plan.blursInTime() && (missesScene || plan.hasFlashes() && isDark(image.get())),
                plan.studio().settings().pixels(),
                sampledPixels,
                clipping(image),
                error,
                complete ? schedule.wantedError() : 0,
                Duration.ofNanos(until - startTime));
    }

    private static boolean isDark(LinearImage image) {
        float[] rgb = image.rgb();
        return IntStream.range(0, rgb.length).noneMatch(i -> rgb[i] > 0);
    }

    /**
     * An unfinished picture is not judged, and neither is one without shifted colours, whose brightness is what the
     * scene says, or one of stars, where black is meant.
     */
    private Clipping clipping(Supplier<LinearImage> image) {
        Studio studio = plan.studio();
        return !complete || studio.colours() == ColourLaw.UNCHANGED || plan.hasStars()
                ? new Clipping(0, 0)
                : Clipping.of(image.get(), studio.settings().toneCurve());
    }
}
