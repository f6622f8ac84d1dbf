package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ProcessorTime;
import tompkins.Waiting;
import tompkins.image.LinearImage;
import tompkins.image.PictureDifference;
import tompkins.light.AmbientLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Sphere;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;
import tompkins.trace.VariedStudios;

@Timeout(600)
class RendererTest {

    /** Samples of each pixel, with which a picture takes hours. */
    private static final int ENDLESS = 4096;

    @ParameterizedTest
    @MethodSource("studios")
    void pictureAndCountsAreTheSameForAnyNumberOfThreads(Studio studio) throws InterruptedException {
        RenderPlan plan = RenderPlan.of(studio);
        RenderJob alone = render(plan, 1);

        RenderJob together = render(plan, 5);

        assertThat(together.image().rgb()).isEqualTo(alone.image().rgb());
        assertThat(together.report())
                .usingRecursiveComparison()
                .ignoringFields("time")
                // one sample of a star tells no error: NaN is NaN here
                .withComparatorForType(Double::compare, Double.class)
                .isEqualTo(alone.report());
    }

    static List<Named<Studio>> studios() {
        return VariedStudios.all()
                .map(named -> Named.of(named.getName(), small(named.getPayload())))
                .toList();
    }

    private static Studio small(Studio studio) {
        int samples = studio.settings().samples();
        return studio.settings().width() > 100 ? size(studio, 100, 75, samples) : studio;
    }

    @Test
    void errorOfAPictureIsToldWhenAllPixelsAreThere() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(size(PaperStudios.fig1b(), 203, 149, 1));
        List<Boolean> told = Collections.synchronizedList(new ArrayList<>());
        RenderListener listener =
                Looks.afterEachPass(job -> told.add(job.report().error() > 0));

        try (Renderer renderer = new Renderer(2)) {
            renderer.startCoarse(plan, Quality.of(plan.studio()), listener).await();
        }

        // of every 8th, 4th, 2nd pixel in both directions, and of all of them
        assertThat(told).containsExactly(false, false, false, true);
    }

    /** The picture of every 8th, 4th, 2nd pixel: interpolated it is nearer to the whole one than in blocks. */
    @ParameterizedTest
    @ValueSource(strings = {"fig1a", "fig1b"})
    void previewsGetBetterAndAreInterpolated(String name) throws InterruptedException {
        Studio figure = name.equals("fig1a") ? PaperStudios.fig1a() : PaperStudios.fig1b();
        RenderPlan plan = RenderPlan.of(size(figure, 320, 240, 1));
        List<LinearImage> pictures = Collections.synchronizedList(new ArrayList<>());
        RenderListener listener = Looks.afterEachPass(job -> pictures.add(job.image()));

        try (Renderer renderer = new Renderer(2)) {
            renderer.startCoarse(plan, Quality.of(plan.studio()), listener).await();
        }

        LinearImage whole = pictures.get(3);
        double last = Double.POSITIVE_INFINITY;
        for (int pass = 0; pass < 3; pass++) {
            double error = PictureDifference.ofLight(pictures.get(pass), whole);
            assertThat(error).isPositive().isLessThan(0.9 * last);
            assertThat(error).isLessThan(PictureDifference.ofLight(blocks(pictures.get(pass), 8 >> pass), whole));
            last = error;
        }
    }

    /** The picture that repeats every so many pixels of each direction. */
    private static LinearImage blocks(LinearImage image, int stride) {
        float[] rgb = new float[image.rgb().length];
        for (int i = 0; i < rgb.length / 3; i++) {
            int row = i / image.width();
            int column = i % image.width();
            int known = (row - row % stride) * image.width() + column - column % stride;
            System.arraycopy(image.rgb(), 3 * known, rgb, 3 * i, 3);
        }
        return new LinearImage(image.width(), image.height(), rgb);
    }

    @Test
    void coarsePassesEndInTheSamePicture() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(size(PaperStudios.fig3a(), 203, 149, 3));
        List<Integer> progress = Collections.synchronizedList(new ArrayList<>());
        RenderListener listener = Looks.afterEachPass(job -> progress.add((int) (100 * job.progress())));

        try (Renderer renderer = new Renderer(2)) {
            RenderJob coarse = renderer.startCoarse(plan, Quality.of(plan.studio()), listener);
            coarse.await();
            RenderJob plain = renderer.render(plan);

            assertThat(coarse.image().rgb()).isEqualTo(plain.image().rgb());
            assertThat(coarse.report().counts().samples)
                    .isEqualTo(plain.report().counts().samples)
                    .isEqualTo(203 * 149 * 3);
            assertThat(coarse.isComplete()).isTrue();
            assertThat(coarse.progress()).isEqualTo(1);
            // 1/64, 1/16, 1/4, 1 of the first of three samples, then one and one
            assertThat(progress).isSorted().hasSize(6).contains(33, 66);
        }
    }

    @Test
    void aLargePictureIsCancelledBetweenItsTiles() throws InterruptedException {
        CountDownLatch firstTile = new CountDownLatch(1);
        AtomicInteger tiles = new AtomicInteger();
        RenderListener listener = new RenderListener() {
            @Override
            public void tileDone(RenderJob job) {
                tiles.incrementAndGet();
                firstTile.countDown();
            }
        };
        try (Renderer renderer = new Renderer(2)) {
            RenderPlan plan = RenderPlan.of(size(PaperStudios.fig3a(), 3840, 2160, 64));
            RenderJob job = renderer.start(plan, Quality.of(plan.studio()), listener);
            firstTile.await();
            job.cancel();
            int before = tiles.get();
            job.await();

            assertThat(tiles.get() - before)
                    .as("what the two threads had in hand")
                    .isBetween(0, 2);
            assertThat(job.isCancelled()).isTrue();
            assertThat(job.isComplete()).isFalse();
            assertThat(job.progress()).isBetween(0.0, 0.5);
            assertThat(anyLight(job.image().rgb())).isTrue();
        }
    }

    /**
     * Of a picture in which each sample is reflected a hundred thousand times, not even the first tile is waited for.
     */
    @Test
    void aPictureIsCancelledWithinATile() throws InterruptedException {
        Sphere mirrors = new Sphere("", new Vector3d(), 9, new Mirror(1));
        Studio studio = size(Studio.DEFAULT.withScene(List.of(mirrors)), 640, 480, ENDLESS);
        RenderPlan plan =
                RenderPlan.of(studio.withSettings(Descriptions.with(studio.settings(), "maximumDepth", 100_000)));
        try (Renderer renderer = new Renderer(2)) {
            RenderJob job = renderer.start(plan, Quality.of(plan.studio()), RenderListener.NONE);
            Waiting.until("tracing", RendererTest::isTracing);
            job.cancel();
            job.await();

            assertThat(job.isCancelled()).isTrue();
            assertThat(job.progress()).isLessThan(1e-3);
        }
    }

    private static boolean isTracing() {
        return Thread.getAllStackTraces().values().stream()
                .flatMap(Stream::of)
                .anyMatch(call -> call.getClassName().equals(SampleTracer.class.getName()));
    }

    /**
     * To plan a pass of so many pixels takes up to a second; sums, since clocks of processors may tick in hundredths.
     */
    @Test
    void aLargePictureEndsSoonWhileItsNextPassIsPlanned() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(size(PaperStudios.fig1b(), 1920, 1080, 1));
        double whole = 0;
        double ended = 0;
        for (int attempt = 0; attempt < 2; attempt++) {
            whole += secondsAfterCentres(plan, false);
            ended += secondsAfterCentres(plan, true);
        }
        assertThat(ended).isLessThan(whole / 3);
    }

    /**
     * Processor time from when each pixel has a sample until the job has ended, or else the first tile of the next
     * pass.
     */
    private static double secondsAfterCentres(RenderPlan plan, boolean cancels) throws InterruptedException {
        // one pixel of each tile, the others, and some that are looked at
        CountDownLatch centres = new CountDownLatch(3);
        AtomicBoolean isOver = new AtomicBoolean();
        RenderListener listener = new RenderListener() {
            @Override
            public void passDone(RenderJob job) {
                centres.countDown();
            }

            @Override
            public void tileDone(RenderJob job) {
                isOver.set(centres.getCount() == 0);
            }

            @Override
            public void ended(RenderJob job) {
                isOver.set(true);
            }
        };
        try (Renderer renderer = new Renderer(2)) {
            RenderJob job = renderer.start(plan, new Quality.TargetError(1e-6), listener);
            centres.await();
            return ProcessorTime.ofProcess(() -> {
                if (cancels) {
                    job.cancel();
                }
                Waiting.until("the end", isOver::get);
            });
        }
    }

    private static boolean anyLight(float[] rgb) {
        for (float value : rgb) {
            if (value > 0) {
                return true;
            }
        }
        return false;
    }

    @Test
    void closingTheRendererEndsAllItsJobs() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(size(PaperStudios.fig3a(), 1920, 1080, ENDLESS));
        AtomicInteger ended = new AtomicInteger();
        RenderListener listener = new RenderListener() {
            @Override
            public void ended(RenderJob job) {
                ended.incrementAndGet();
            }
        };
        Renderer renderer = new Renderer(2);
        RenderJob running = renderer.start(plan, Quality.of(plan.studio()), listener);
        RenderJob waiting = renderer.start(plan, Quality.of(plan.studio()), listener);
        RenderJob alsoWaiting = renderer.startCoarse(plan, Quality.of(plan.studio()), listener);

        renderer.close();
        running.await();
        waiting.await();
        alsoWaiting.await();

        assertThat(List.of(running, waiting, alsoWaiting)).allMatch(RenderJob::isCancelled);
        assertThat(ended).hasValue(3);
        assertThatIllegalStateException()
                .isThrownBy(() -> renderer.start(plan, Quality.of(plan.studio()), listener))
                .withMessage("the renderer is closed");
    }

    @Test
    void severalJobsRunAtATime() throws InterruptedException {
        RenderPlan large = RenderPlan.of(size(PaperStudios.fig1b(), 300, 200, 2));
        RenderPlan small = RenderPlan.of(size(PaperStudios.fig1a(), 60, 40, 1));

        try (Renderer renderer = new Renderer(2)) {
            RenderJob first = renderer.start(large, Quality.of(large.studio()), RenderListener.NONE);
            RenderJob second = renderer.startCoarse(small, Quality.of(small.studio()), RenderListener.NONE);
            first.await();
            second.await();

            assertThat(first.image().rgb()).isEqualTo(render(large, 1).image().rgb());
            assertThat(second.image().rgb()).isEqualTo(render(small, 1).image().rgb());
        }
    }

    @Test
    void aFailureNamesTheSampleAndLeavesTheRendererInOrder() throws InterruptedException {
        RenderPlan fails = planOfBottomlessSurface();

        try (Renderer renderer = new Renderer(2)) {
            assertThatThrownBy(() -> renderer.render(fails))
                    .isInstanceOf(RenderFailedException.class)
                    .hasMessageMatching("pixel \\d+,\\d+, sample 0: java.lang.StackOverflowError")
                    .hasCauseInstanceOf(StackOverflowError.class);
            assertThat(renderer.render(RenderPlan.of(size(PaperStudios.fig1a(), 64, 48, 1)))
                            .isComplete())
                    .isTrue();
        }
    }

    /** A sphere with tiles on tiles on tiles: too many for the stack of a rendering thread. */
    private static RenderPlan planOfBottomlessSurface() throws InterruptedException {
        Surface surface = ColouredSurface.DEFAULT;
        for (int depth = 0; depth < 600_000; depth++) {
            surface = new Tiling(ColouredSurface.DEFAULT, surface, 0.25, 0.25, false);
        }
        Studio studio = size(PaperStudios.fig1a(), 64, 48, 1)
                .withScene(List.of(new Sphere("tiled", new Vector3d(0, 0, 10), 0.5, surface)));
        AtomicReference<RenderPlan> plan = new AtomicReference<>();
        Thread planner = new Thread(null, () -> plan.set(RenderPlan.of(studio)), "planner", 1L << 30);
        planner.start();
        planner.join();
        return plan.get();
    }

    /** A float ends at 3.4 x 10^38; what lamps and surfaces have may be 10^20 each. */
    @ParameterizedTest
    @CsvSource({"1e10, 1e20, 0", "1e19, 1e20, 48", "1e20, 1e20, 48"})
    void lightThatNoPictureCanHoldStaysBlackAndIsToldOf(double lamp, double share, int told)
            throws InterruptedException {
        Surface sky = new ColouredSurface(Colour.grey(share), Colour.BLACK);
        RenderPlan plan = RenderPlan.of(Descriptions.with(
                        size(PaperStudios.fig1a(), 8, 6, 1), "lights", List.of(new AmbientLight(Colour.grey(lamp))))
                .withScene(List.of(new Sphere("sky", new Vector3d(0, 0, 0), 1000, sky))));

        RenderJob job = render(plan, 1);

        assertThat(job.report().counts().notFinite).isEqualTo(told);
        assertThat(job.image().value(3, 2, 1)).isEqualTo(told == 0 ? (float) (lamp * share) : 0);
        assertThat(job.report().warnings()).hasSize(told == 0 ? 0 : 1);
    }

    /** Floats end after seven digits: a quarter of a million of them, added one by one, would be wrong in the third. */
    @Test
    void manySamplesOfTheSameLightHaveItAsTheirMean() throws InterruptedException {
        Colour grey = new Colour(0.7, 0.1, 1.0 / 3);
        RenderPlan plan = RenderPlan.of(size(PaperStudios.fig1a(), 1, 1, 1 << 18)
                .withScene(List.of(new Sphere("sky", new Vector3d(0, 0, 0), 1000, new LuminousSurface(grey, false)))));

        LinearImage image = render(plan, 1).image();

        assertThat(image.value(0, 0, 0)).isCloseTo(0.7f, within(1e-6f));
        assertThat(image.value(0, 0, 1)).isCloseTo(0.1f, within(1e-6f));
        assertThat(image.value(0, 0, 2)).isCloseTo(1 / 3f, within(1e-6f));
    }

    @Test
    void aListenersMistakeEndsTheJob() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(size(PaperStudios.fig1a(), 128, 96, 4));
        RenderListener broken = new RenderListener() {
            @Override
            public void tileDone(RenderJob job) {
                throw new IllegalStateException("broken");
            }
        };

        try (Renderer renderer = new Renderer(2)) {
            RenderJob job = renderer.start(plan, Quality.of(plan.studio()), broken);

            assertThatThrownBy(job::await)
                    .isInstanceOf(RenderFailedException.class)
                    .hasMessage("java.lang.IllegalStateException: broken");
            assertThat(job.isComplete()).isFalse();
        }
    }

    /** The film has 16 or 32 bytes a pixel, the picture 12, its file 6, and the estimate of its error 0, 8 or 20. */
    @ParameterizedTest
    @CsvSource({"3000, 1, 42", "10, 1, 42", "10, 2, 70", "2000, 4, 70", "2001, 4, 34"})
    void memoryIsThatOfFilmFileAndEstimate(int side, int samples, int bytes) {
        Studio studio = size(PaperStudios.fig1a(), side, 2000, samples);
        assertThat(Renderer.bytesOfMemory(studio.settings(), Quality.of(studio)))
                .isEqualTo(2000L * side * bytes);
    }

    private static RenderJob render(RenderPlan plan, int threads) throws InterruptedException {
        try (Renderer renderer = new Renderer(threads)) {
            return renderer.render(plan);
        }
    }

    private static Studio size(Studio studio, int width, int height, int samples) {
        return studio.withSettings(studio.settings().withSize(width, height).withSamples(samples));
    }
}
