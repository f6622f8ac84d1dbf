package tompkins.render;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.DoubleAdder;
import java.util.function.Consumer;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTaker;
import tompkins.trace.SampleTracer;

/**
 * One picture on its way. The threads of the renderer take tiles from one counter, pass by pass; a thread that finds the
 * pass used up waits for the others, so that each pass is complete before the next begins.
 */
public final class RenderJob {

    private final RenderPlan plan;
    private final List<Pass> passes;
    private final List<Tile> tiles;
    private final RenderListener listener;
    private final Consumer<RenderJob> whenEnded;
    private final Film film;
    private final double allWork;
    private final int workers;
    private final long startTime = System.nanoTime();

    private final AtomicInteger nextTile = new AtomicInteger();
    private final AtomicInteger tilesDone = new AtomicInteger();
    private final AtomicInteger workersEnded = new AtomicInteger();
    private final DoubleAdder workDone = new DoubleAdder();
    private final CountDownLatch end = new CountDownLatch(1);
    private final AtomicReference<RenderFailedException> failure = new AtomicReference<>();
    private final Object passLock = new Object();
    private final RayCounts counts = new RayCounts();
    private long nodes;
    private long tests;
    private volatile boolean cancelled;
    private volatile int passesDone;
    private volatile long endTime;

    RenderJob(RenderPlan plan, List<Pass> passes, int workers, RenderListener listener, Consumer<RenderJob> whenEnded) {
        this.plan = plan;
        this.passes = passes;
        this.workers = workers;
        this.listener = listener;
        this.whenEnded = whenEnded;
        tiles = Tile.of(plan.width(), plan.height());
        film = new Film(plan.width(), plan.height());
        allWork = passes.stream().mapToDouble(Pass::work).sum();
    }

    /** What one thread does for this job. Whatever goes wrong is kept, so that nobody waits for a thread that has gone. */
    void work() {
        RayCounts mine = new RayCounts();
        SampleTracer tracer = null;
        try {
            tracer = plan.tracer(mine);
            renderTiles(tracer);
        } catch (RuntimeException | Error error) {
            failure.compareAndSet(null, new RenderFailedException(error));
        } finally {
            workerEnded(mine, tracer);
        }
    }

    private void renderTiles(SampleTracer tracer) {
        int all = passes.size() * tiles.size();
        for (int index = nextTile.getAndIncrement(); index < all; index = nextTile.getAndIncrement()) {
            int pass = index / tiles.size();
            if (!waitForPass(pass)) {
                return;
            }
            Tile tile = tiles.get(index % tiles.size());
            renderTile(passes.get(pass), tile, tracer);
            if (!isStopped()) {
                tileDone(passes.get(pass), tile);
            }
        }
    }

    private void renderTile(Pass pass, Tile tile, SampleTracer tracer) {
        SampleTaker taker = new SampleTaker() {
            @Override
            public boolean wants(int column, int row) {
                return pass.takes(column, row) && !cancelled;
            }

            @Override
            public void take(int column, int row, Colour colour) {
                film.add(column, row, colour);
            }
        };
        int side = SampleTracer.LARGEST_BLOCK * pass.stride();
        int end = pass.firstSample() + pass.samples();
        for (int row = 0; row < tile.height(); row += side) {
            for (int column = 0; column < tile.width(); column += side) {
                int width = Math.min(side, tile.width() - column);
                int height = Math.min(side, tile.height() - row);
                for (int sample = pass.firstSample(); sample < end && !isStopped(); sample++) {
                    try {
                        tracer.sampleBlock(
                                tile.column() + column, tile.row() + row, width, height, pass.stride(), sample, taker);
                    } catch (RuntimeException | Error error) {
                        failure.compareAndSet(
                                null, new RenderFailedException(tracer.column(), tracer.row(), sample, error));
                    }
                }
            }
        }
    }

    private void tileDone(Pass pass, Tile tile) {
        workDone.add(pass.work() / tiles.size());
        listener.tileDone(this, tile);
        if (tilesDone.incrementAndGet() % tiles.size() == 0) {
            // before the others go on, so that nobody adds to the film while the listener looks at it
            listener.passDone(this);
            synchronized (passLock) {
                passesDone++;
                passLock.notifyAll();
            }
        }
    }

    /** Waits until the passes before this one are complete; false if the job was stopped meanwhile. */
    private boolean waitForPass(int pass) {
        synchronized (passLock) {
            while (passesDone < pass && !isStopped()) {
                try {
                    passLock.wait(10);
                } catch (InterruptedException closing) {
                    cancelled = true;
                    Thread.currentThread().interrupt();
                }
            }
        }
        return !isStopped();
    }

    private void workerEnded(RayCounts mine, SampleTracer tracer) {
        synchronized (counts) {
            counts.add(mine);
            nodes += tracer == null ? 0 : tracer.nodes();
            tests += tracer == null ? 0 : tracer.tests();
        }
        if (workersEnded.incrementAndGet() == workers) {
            endTime = System.nanoTime();
            end.countDown();
            whenEnded.accept(this);
            listener.ended(this);
        }
    }

    private boolean isStopped() {
        return cancelled || failure.get() != null || Thread.currentThread().isInterrupted();
    }

    /** Ends the job soon: within one sample of each thread. */
    public void cancel() {
        cancelled = true;
    }

    /** Whether the job was cancelled before it was complete. */
    public boolean isCancelled() {
        return cancelled && passesDone < passes.size();
    }

    /** Whether all samples were taken. */
    public boolean isComplete() {
        return passesDone == passes.size();
    }

    /** The share of the work that is done, from 0 to 1. */
    public double progress() {
        return isComplete() ? 1 : Math.min(1, workDone.sum() / allWork);
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

    /** The first sample that failed, or null. */
    public RenderFailedException failure() {
        return failure.get();
    }

    /** The picture so far, in linear light, with exposure compensation. */
    public LinearImage image() {
        return film.image(Math.pow(2, plan.studio().camera().exposureStops()));
    }

    /** The plan of the picture. */
    public RenderPlan plan() {
        return plan;
    }

    /** What was done; complete once the job has ended. */
    public RenderReport report() {
        long until = end.getCount() == 0 ? endTime : System.nanoTime();
        synchronized (counts) {
            return RenderReport.of(counts, nodes, tests, Duration.ofNanos(until - startTime));
        }
    }
}
