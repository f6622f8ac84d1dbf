package tompkins.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.Velocity;
import tompkins.studio.PaperStudios;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

/** Samples go where they are needed, and the error is what the report says. */
class AdaptiveRenderTest {

    private static final Renderer RENDERER = new Renderer(2);
    private static final Map<Studio, float[]> REFERENCES = new HashMap<>();
    private static final Map<Studio, float[]> OTHER_REFERENCES = new HashMap<>();
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(64, 48);

    @AfterAll
    static void close() {
        RENDERER.close();
    }

    /** One in the centre, which sixteen replace at the border and in every 17th pixel. */
    @Test
    void pinholeWithoutEdgesTakesFewSamples() throws InterruptedException {
        Studio empty = studio(List.of(), 0).withSettings(SMALL.withSize(640, 480));
        RenderJob job = render(empty, new Quality.TargetError(0.001));
        double border = 2.0 * (640 + 480 - 2) / (640 * 480);
        assertThat(job.report().samplesPerPixel()).isCloseTo(1 + 16 * (border + (1 - border) / 17), within(0.001));
        assertThat(job.report().error()).isZero();
    }

    /**
     * A bright strip, 0.4 pixels high, that no centre of a pixel meets: between two rows, and beyond those last ones.
     */
    @ParameterizedTest
    @ValueSource(doubles = {3, 23.75, -23.75})
    void whatLiesBetweenTheCentresIsFound(double middle) throws InterruptedException {
        double pixel = 2 * 10 * Math.tan(Math.toRadians(10)) / 64;
        Vector3d corner = new Vector3d(-5, (middle - 0.2) * pixel, 10);
        Parallelogram strip = new Parallelogram(
                "strip",
                corner,
                new Vector3d(10, 0, 0),
                new Vector3d(0, 0.4 * pixel, 0),
                new LuminousSurface(Colour.WHITE, false));
        Studio studio = studio(List.of(strip), 0);
        double background = ((UniformBackground) studio.background()).colour().red();
        assertThat(background).isLessThan(0.6);
        assertThat(lightAbove(background, render(studio, new Quality.Samples(1))))
                .as("the centres meet nothing")
                .isZero();

        RenderJob job = render(studio, new Quality.TargetError(0.004));

        assertThat(lightAbove(background, job)).isCloseTo(64 * 0.4 * (1 - background), withinPercentage(2));
        assertThat(trueError(studio, job)).isLessThan(1.25 * 0.004);
    }

    private static double lightAbove(double background, RenderJob job) {
        float[] values = job.image().rgb();
        double sum = 0;
        for (int i = 0; i < values.length; i += 3) {
            sum += values[i] - (float) background;
        }
        return sum;
    }

    @Test
    void pinholeTakesMoreSamplesAtEdgesOnly() throws InterruptedException {
        RenderJob job = render(studio(spheres(), 0), new Quality.TargetError(0.004));
        assertThat(job.report().samplesPerPixel()).isBetween(1.5, 60.0);
        assertThat(job.report().error()).isBetween(0.001, 0.004);
        assertThat(trueError(studio(spheres(), 0), job)).isLessThan(1.25 * 0.004);
    }

    /** Of 64 x 48 pixels the first pass takes every 8th in both directions: 8 x 6. */
    @Test
    void pixelsWithoutSamplesAreToldOf() throws InterruptedException {
        RenderListener impatient = Looks.afterEachPass(RenderJob::cancel);
        RenderJob job = RENDERER.start(RenderPlan.of(studio(spheres(), 0)), new Quality.TimeLimit(100), impatient);
        job.await();

        assertThat(job.report().sampledPixels()).isEqualTo(48);
        assertThat(job.report().warnings())
                .containsExactly("3024 of 3072 pixels got no sample and are interpolated between the others");
    }

    /** The camera goes past at half the speed of light; the nearest sphere moves by tens of pixels meanwhile. */
    @ParameterizedTest
    @CsvSource({"0.01, 0.1, 0", "0.003, 0.1, 0", "0.01, 2, 0", "0.003, 2, 0", "0.003, 0.5, 3"})
    void longExposureIsHonest(double target, double exposure, double sweep) throws InterruptedException {
        Studio studio = exposed(studio(spheres(), 0), 0.5, exposure, sweep);
        RenderJob job = render(studio, new Quality.TargetError(target));
        assertThat(job.report().samplesPerPixel()).isGreaterThanOrEqualTo(AdaptiveSchedule.FIRST_SAMPLES);
        assertThat(job.report().error()).isLessThanOrEqualTo(target);
        assertThat(trueError(studio, job)).isLessThan(1.25 * target);
    }

    /**
     * A ball of two pixels flies over 40 of 64 pixels while nothing else moves. Its light is spread over its way and
     * stays the same in all: the area of the ball.
     */
    @Test
    void smallFastBallIsFound() throws InterruptedException {
        double pixel = 2 * 10 * Math.tan(Math.toRadians(10)) / 64;
        Sphere ball = new Sphere("ball", new Vector3d(0, 0.6, 10), pixel, new LuminousSurface(Colour.WHITE, false));
        double slow = 0.001;
        Studio studio = exposed(studio(List.of(ball), 0), slow, 40 * pixel / slow, 0);
        studio = studio.withCamera(studio.camera().withShutter(new AperturePlaneShutter(-20 * pixel / slow)));
        double background = ((UniformBackground) studio.background()).colour().red();

        RenderJob job = render(studio, new Quality.TargetError(0.0005));

        assertThat(lightAbove(background, job)).isCloseTo(Math.PI * (1 - background), withinPercentage(2));
        assertThat(trueError(studio, job)).isLessThan(1.25 * 0.0005);
        assertThat(job.report().samplesPerPixel()).isLessThan(64);
    }

    @Test
    void stillPictureCostsNothingMore() throws InterruptedException {
        Studio still = studio(spheres(), 0);
        RenderJob instant = render(still, new Quality.TargetError(0.004));
        RenderJob exposed = render(exposed(still, 0, 3, 2), new Quality.TargetError(0.004));
        assertThat(exposed.report().counts().samples).isEqualTo(instant.report().counts().samples);
        assertThat(exposed.image().rgb()).isEqualTo(instant.image().rgb());
    }

    private static Studio exposed(Studio studio, double speed, double exposure, double sweep) {
        Camera slow = Descriptions.with(studio.camera(), "exposureTime", exposure);
        return studio.withVelocity(Velocity.of(speed, 0, 0))
                .withCamera(Descriptions.with(slow, "rollingShutter", new RollingShutter(SweepDirection.DOWN, sweep)));
    }

    @Test
    void takesFewerSamplesThanTheSameNumberEverywhere() throws InterruptedException {
        Studio studio = studio(spheres(), 0.05);
        RenderJob adaptive = render(studio, new Quality.TargetError(0.003));
        int samples = (int) Math.ceil(adaptive.report().samplesPerPixel());
        RenderJob fixed = render(studio, new Quality.Samples(samples));
        assertThat(trueError(studio, adaptive)).isLessThan(0.7 * trueError(studio, fixed));
    }

    @Test
    void numberOfThreadsDoesNotMatter() throws InterruptedException {
        RenderPlan plan = RenderPlan.of(studio(spheres(), 0.1));
        Quality quality = new Quality.TargetError(0.005);
        try (Renderer one = new Renderer(1);
                Renderer three = new Renderer(3)) {
            assertThat(three.render(plan, quality).image().rgb())
                    .containsExactly(one.render(plan, quality).image().rgb());
        }
    }

    @Test
    void endsWhenTheTimeIsOver() throws InterruptedException {
        RenderJob job = render(studio(spheres(), 0.1), new Quality.TimeLimit(0.1));
        assertThat(job.isComplete()).isTrue();
        assertThat(job.report().time().toMillis()).isGreaterThanOrEqualTo(50L);
        double error = trueError(studio(spheres(), 0.1), job);
        assertThat(job.report().error()).isBetween(0.7 * error, 3 * error);
    }

    /** Pixels of noise on a machine that takes a nanosecond for each: all of a million of them, and no more. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-15, 1, 1e11, 1e30})
    void usesUpItsTime(double brightness) {
        AtomicLong clock = new AtomicLong();
        Film film = new Film(16, 16, 1, true);
        AdaptiveSchedule schedule = new AdaptiveSchedule(film, true, true, 0, new TimeBudget(1e-3, clock::get));
        SplittableRandom random = new SplittableRandom(5);
        for (Pass pass = schedule.next(() -> false); pass != null; pass = schedule.next(() -> false)) {
            for (int pixel = 0; pixel < 16 * 16; pixel++) {
                boolean wanted = pixel % 16 % pass.stride() == 0 && pixel / 16 % pass.stride() == 0;
                if (wanted && pass.takes(pixel % 16, pixel / 16, pixel)) {
                    for (int sample = 0; sample < pass.samples(); sample++) {
                        double light = random.nextBoolean() ? brightness : 0;
                        Films.add(film, pixel, light, light, light, 1);
                        clock.incrementAndGet();
                    }
                }
            }
        }
        assertThat(clock.get()).isBetween(900_000L, 1_100_000L);
    }

    @Test
    void reportsTheErrorOfFixedSamples() throws InterruptedException {
        Studio studio = studio(spheres(), 0.1);
        for (int samples : new int[] {16, 48, 256}) {
            RenderJob job = render(studio, new Quality.Samples(samples));
            double error = trueError(studio, job);
            assertThat(job.report().error()).as("%d samples", samples).isBetween(0.8 * error, 2.5 * error);
        }
        assertThat(render(studio, new Quality.Samples(1)).report().error()).isNaN();
    }

    /** All samples fill pixel and lens more evenly than each half of them, whose difference tells the error. */
    @Test
    void theErrorOfABlurIsNotOverstated() throws InterruptedException {
        Studio studio = PaperStudios.fig3a().withSettings(RenderSettings.DEFAULT.withSize(96, 72));
        RenderJob job = render(studio, new Quality.Samples(64));
        assertThat(job.report().error() / trueError(studio, job)).isBetween(0.9, 1.15);
    }

    /** Three pixels in a line have a second difference; fewer have nothing to compare, and no error to tell. */
    @ParameterizedTest
    @CsvSource({"1, 1, false", "2, 2, false", "3, 1, true", "1, 3, true"})
    void singleSamplesTellAnErrorOnlyBesideOthers(int width, int height, boolean tells) throws InterruptedException {
        Studio studio = studio(spheres(), 0).withSettings(SMALL.withSize(width, height));
        assertThat(Double.isNaN(render(studio, new Quality.Samples(1)).report().error()))
                .isEqualTo(!tells);
        assertThat(render(studio, new Quality.Samples(2)).report().error()).isNotNaN();
    }

    @Test
    void aPictureWithNothingToCompareIsAsGoodAsWanted() throws InterruptedException {
        Studio studio = studio(spheres(), 0).withSettings(SMALL.withSize(2, 2));
        RenderJob job = render(studio, new Quality.TargetError(0.004));
        assertThat(job.report().error()).isBetween(0.0001, 0.004);
        assertThat(trueError(studio, job)).isLessThan(2 * 0.004);
    }

    /** Four pixels with all the samples that they may get: the work is known from the first plan on, and ends there. */
    @Test
    void anErrorThatCannotBeReachedIsToldOf() throws InterruptedException {
        Studio studio = studio(spheres(), 0.2).withSettings(SMALL.withSize(2, 2));
        List<Double> progress = new ArrayList<>();
        RenderListener afterEachPass = Looks.afterEachPass(job -> progress.add(job.progress()));
        RenderJob job = RENDERER.start(RenderPlan.of(studio), new Quality.TargetError(1e-6), afterEachPass);
        job.await();

        assertThat(job.report().samplesPerPixel()).isEqualTo(65536);
        assertThat(job.report().warnings())
                .containsExactly("the estimated error did not come down to 0.000001: no pixel gets more than 65536"
                        + " samples");
        // each round takes as many samples as all before it
        assertThat(progress.get(progress.size() - 2)).isEqualTo(0.5);
        assertThat(progress.get(progress.size() - 1)).isEqualTo(1);
    }

    /** Half of the pixels are noise that stays too strong, the others hardly any: those are raised, too, to no end. */
    @Test
    void progressIsKnownOnceNothingMoreHelps() {
        Film film = new Film(16, 16, 1, true);
        TimeBudget unlimited = new TimeBudget(Double.POSITIVE_INFINITY);
        AdaptiveSchedule schedule = new AdaptiveSchedule(film, true, false, 1e-5, unlimited);
        SplittableRandom random = new SplittableRandom(5);
        long samples = 0;
        for (Pass pass = schedule.next(() -> false); pass != null; pass = schedule.next(() -> false)) {
            assertThat(schedule.progress(1)).isBetween(1.0 / 65536, 1.0);
            for (int pixel = 0; pixel < 16 * 16; pixel++) {
                if (pass.takes(pixel % 16, pixel / 16, pixel)) {
                    for (int sample = 0; sample < pass.samples(); sample++) {
                        double light = (pixel % 16 < 8 ? 1 : 1e-4) * random.nextInt(2);
                        Films.add(film, pixel, light, light, light, 1);
                        samples++;
                    }
                }
            }
        }
        assertThat(schedule.progress(samples / 256.0)).isBetween(0.99, 1.01);
    }

    @Test
    void nobodyWaitsForALookThatIsNotWantedAnyMore() {
        Film film = new Film(64, 48, 1, true);
        AdaptiveSchedule schedule =
                new AdaptiveSchedule(film, false, false, 0.01, new TimeBudget(Double.POSITIVE_INFINITY));
        assertThat(schedule.next(() -> false))
                .as("the first centre of each tile")
                .isNotNull();
        assertThat(schedule.next(() -> false)).as("the other centres").isNotNull();

        assertThatThrownBy(() -> schedule.next(() -> true)).isInstanceOf(CancellationException.class);
    }

    private static RenderJob render(Studio studio, Quality quality) throws InterruptedException {
        return RENDERER.render(RenderPlan.of(studio), quality);
    }

    /**
     * The root mean square error: the difference from many samples of two other seeds, without the error of their mean,
     * which is half of the difference between them.
     */
    private static double trueError(Studio studio, RenderJob job) throws InterruptedException {
        float[] one = REFERENCES.computeIfAbsent(studio, of -> reference(of, 77));
        float[] other = OTHER_REFERENCES.computeIfAbsent(studio, of -> reference(of, 78));
        float[] values = job.image().rgb();
        double sum = 0;
        for (int i = 0; i < values.length; i++) {
            double difference = values[i] - (one[i] + other[i]) / 2;
            double ofReference = (one[i] - other[i]) / 2;
            sum += difference * difference - ofReference * ofReference;
        }
        return Math.sqrt(Math.max(0, sum / values.length));
    }

    private static float[] reference(Studio studio, long seed) {
        try {
            Studio other = studio.withSettings(studio.settings().withSeed(seed));
            return render(other, new Quality.Samples(1024)).image().rgb();
        } catch (InterruptedException interrupted) {
            throw new AssertionError(interrupted);
        }
    }

    private static Studio studio(List<SceneObject> scene, double apertureRadius) {
        Plane focus = new Plane("focus", new Vector3d(0, 0, 8), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Camera camera = Descriptions.with(
                Descriptions.with(ThinLensCamera.DEFAULT, "apertureRadius", apertureRadius), "focus", focus);
        return Studio.DEFAULT.withScene(scene).withCamera(camera).withSettings(SMALL);
    }

    private static List<SceneObject> spheres() {
        LuminousSurface white = new LuminousSurface(Colour.WHITE, false);
        LuminousSurface red = new LuminousSurface(new Colour(0.9, 0.1, 0.1), false);
        return List.of(
                new Sphere("near", new Vector3d(0.3, 0.1, 5), 0.3, white),
                new Sphere("middle", new Vector3d(-0.6, -0.2, 8), 0.4, red),
                new Sphere("far", new Vector3d(0.2, 0.6, 15), 0.1, white));
    }
}
