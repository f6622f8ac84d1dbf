package tompkins.render;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import tompkins.image.ToneCurve;
import tompkins.property.MistakeException;
import tompkins.studio.RenderSettings;
import tompkins.trace.RenderPlan;

/** A pool of threads that renders pictures, one after the other or several at a time. */
public final class Renderer implements AutoCloseable {

    /** Enough for the deepest recursion that surfaces ask for. */
    private static final long STACK_BYTES = 16 << 20;

    /** Larger pictures with a fixed number of samples get no estimate of their error. */
    private static final long MOST_PIXELS_WITH_ESTIMATE = 4_000_000;

    private final int threads;
    private final ExecutorService pool;
    private final Set<RenderJob> jobs = ConcurrentHashMap.newKeySet();
    private final PreviewBudget previewBudget = new PreviewBudget();

    /** A renderer with one thread for each core. */
    public Renderer() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /**
     * A renderer with a number of threads.
     *
     * @throws IllegalArgumentException if it is below 1
     */
    public Renderer(int threads) {
        if (threads < 1) {
            throw new IllegalArgumentException("threads must be 1 or above, was " + threads);
        }
        this.threads = threads;
        ThreadFactory factory = task -> {
            Thread thread = new Thread(null, task, "tompkins-render", STACK_BYTES);
            thread.setDaemon(true);
            return thread;
        };
        pool = Executors.newFixedThreadPool(threads, factory);
    }

    /** Starts a picture of some quality from its plan. Returns at once. */
    public RenderJob start(RenderPlan plan, Quality quality, RenderListener listener) {
        return start(plan, quality, false, Tile.of(plan.width(), plan.height()), listener);
    }

    /**
     * Starts a picture for the window: the first sample of each pixel is taken coarse to fine, unless there are stars,
     * which coarse pictures blow up or lose. Returns at once.
     */
    public RenderJob startCoarse(RenderPlan plan, Quality quality, RenderListener listener) {
        return start(plan, quality, !plan.hasStars(), Tile.of(plan.width(), plan.height()), listener);
    }

    /**
     * Starts a picture that is seen for a moment: the first samples of a part of the pixels, and what lies between
     * them. It ends as soon as most of it is right, or after about so many seconds, with the time of the listener. A
     * picture with stars gets one sample of each pixel, or they would twinkle. Returns at once.
     */
    public RenderJob startGlimpse(RenderPlan plan, double seconds, RenderListener listener) {
        int width = plan.width();
        int height = plan.height();
        PixelBuffer buffer;
        Schedule schedule;
        if (plan.hasStars()) {
            buffer = new Film(width, height, plan.exposure(), false);
            schedule = new FixedSchedule(Pass.of(1, 1, false));
        } else {
            ToneCurve curve = plan.studio().settings().toneCurve();
            PreviewFilm preview = new PreviewFilm(width, height, plan.exposure(), curve);
            buffer = preview;
            schedule = new EdgeSchedule(preview, speed -> previewBudget.most(speed, seconds, width * height));
        }
        long start = System.nanoTime();
        return start(plan, schedule, buffer, Tile.of(width, height), listener, job -> {
            if (job.isComplete()) {
                previewBudget.ended((System.nanoTime() - start) * 1e-9, seconds);
            }
        });
    }

    /** Starts some tiles of a picture. */
    RenderJob start(RenderPlan plan, Quality quality, boolean coarseFirst, List<Tile> tiles, RenderListener listener) {
        boolean comparesSamples = needsHalves(plan.studio().settings(), quality);
        Film film = new Film(plan.width(), plan.height(), plan.exposure(), comparesSamples);
        return start(plan, schedule(plan, quality, coarseFirst, film), film, tiles, listener, job -> {});
    }

    /** Starts some tiles of a picture by a schedule; {@code afterwards} is called once the listener knows the end. */
    RenderJob start(
            RenderPlan plan,
            Schedule schedule,
            PixelBuffer buffer,
            List<Tile> tiles,
            RenderListener listener,
            Consumer<RenderJob> afterwards) {
        RenderJob job = new RenderJob(plan, schedule, buffer, tiles, threads, listener, ended -> {
            jobs.remove(ended);
            afterwards.accept(ended);
        });
        jobs.add(job);
        try {
            for (int worker = 0; worker < threads; worker++) {
                pool.execute(job::work);
            }
        } catch (RejectedExecutionException closed) {
            // the part that the pool had already taken must not be rendered
            job.cancel();
            jobs.remove(job);
            throw new IllegalStateException("the renderer is closed", closed);
        }
        return job;
    }

    /**
     * Whether the film has to compare halves of a pixel's samples: not for a single sample, and not for the error
     * estimate alone where the picture is so large that memory matters more.
     */
    private static boolean needsHalves(RenderSettings settings, Quality quality) {
        return !(quality instanceof Quality.Samples fixed)
                || (fixed.samples() > 1 && settings.pixels() <= MOST_PIXELS_WITH_ESTIMATE);
    }

    /** The bytes of a picture that is saved while its error is estimated: film, light, levels of the file, estimate. */
    static long bytesOfMemory(RenderSettings settings, Quality quality) {
        boolean comparesSamples = needsHalves(settings, quality);
        int picture = 3 * Float.BYTES;
        int levels = 3 * Short.BYTES;
        boolean isEstimated = comparesSamples || quality.equals(new Quality.Samples(1));
        int estimate = isEstimated ? PixelVariance.bytesPerPixel(comparesSamples) : 0;
        return settings.pixels() * (Film.bytesPerPixel(comparesSamples) + picture + levels + estimate);
    }

    /**
     * Refuses pictures that the memory of this Java machine cannot hold, before any time is spent on them.
     *
     * @throws MistakeException with what is needed and what there is
     */
    public static void requireMemory(RenderSettings settings, Quality quality) {
        long needed = bytesOfMemory(settings, quality);
        long most = Runtime.getRuntime().maxMemory();
        if (needed > most) {
            throw new MistakeException(String.format(
                    Locale.ROOT,
                    "a picture of %d x %d pixels needs about %d MB of memory, and Java may use %d MB;"
                            + " take a smaller --size, or start java with a larger -Xmx",
                    settings.width(),
                    settings.height(),
                    needed >> 20,
                    most >> 20));
        }
    }

    private static Schedule schedule(RenderPlan plan, Quality quality, boolean coarseFirst, Film film) {
        if (quality instanceof Quality.Samples fixed) {
            return new FixedSchedule(Pass.of(fixed.samples(), fixed.samples(), coarseFirst));
        }
        boolean severalFirst = PixelVariance.needsSeveralSamples(plan);
        if (quality instanceof Quality.TimeLimit limit) {
            return new AdaptiveSchedule(film, severalFirst, true, 0, new TimeBudget(limit.seconds()));
        }
        double error = ((Quality.TargetError) quality).rootMeanSquare();
        return new AdaptiveSchedule(film, severalFirst, coarseFirst, error, new TimeBudget(Double.POSITIVE_INFINITY));
    }

    /** Renders a picture, with as many samples as its scene says, and waits for it. */
    public RenderJob render(RenderPlan plan) throws InterruptedException {
        return render(plan, Quality.of(plan.studio()));
    }

    /** Renders a picture of some quality and waits for it. */
    public RenderJob render(RenderPlan plan, Quality quality) throws InterruptedException {
        RenderJob job = start(plan, quality, RenderListener.NONE);
        job.await();
        return job;
    }

    /** Ends all threads; jobs that still run end as cancelled. */
    @Override
    public void close() {
        List<Runnable> notBegun = pool.shutdownNow();
        jobs.forEach(RenderJob::cancel);
        // jobs that no thread has begun end here, so that nobody waits for them forever
        notBegun.forEach(Runnable::run);
        try {
            pool.awaitTermination(1, TimeUnit.SECONDS);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
