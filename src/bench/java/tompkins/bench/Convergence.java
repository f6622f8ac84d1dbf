package tompkins.bench;

import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import tompkins.image.LinearImage;
import tompkins.image.PictureDifference;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/**
 * How many samples the wide aperture of Fig. 3(a) needs: those that the program takes for a promised error, against
 * random points of pixel and lens for the error that it reached. The error is that of some of the pixels, chosen at
 * random, against many more samples with another seed.
 */
final class Convergence {

    private static final double PROMISED = 0.002;
    private static final int RANDOM_SAMPLES = 64;
    private static final double GOOD = 0.01;
    private static final double FIRST_LOOK = 0.03;
    private static final int TURNS = 5;

    private final Studio studio;
    private final int[] pixels;
    private final int referenceSamples;

    /** A comparison for a picture of the given width. */
    Convergence(int width, int pixels, int referenceSamples) {
        Studio figure = PaperStudios.fig3a();
        studio = figure.withSettings(figure.settings().withSize(width, width * 3 / 4));
        this.pixels = new Random(5).ints(pixels, 0, width * width * 3 / 4).toArray();
        this.referenceSamples = referenceSamples;
    }

    /** Takes pictures, compares the number of samples, and the times to a good and to a first look. */
    void measure(List<Measure> measures) throws InterruptedException {
        measures.add(samples());
        try (Renderer renderer = new Renderer()) {
            RenderPlan plan = RenderPlan.of(studio);
            LinearImage whole = renderer.render(plan, new Quality.Samples(256)).image();
            double[][] times = new double[3][TURNS];
            for (int turn = 0; turn < 2 * TURNS; turn++) {
                // what is compiled in the first half is not counted
                times[0][turn % TURNS] = milliseconds(renderer, plan, new Quality.Samples(1));
                times[1][turn % TURNS] = milliseconds(renderer, plan, new Quality.TargetError(GOOD));
                times[2][turn % TURNS] = firstLook(renderer, plan, whole);
            }
            measures.add(Measure.of(
                    "fig3a: to an error of " + GOOD + ", in pictures of one sample",
                    "x",
                    Measure.median(times[1]) / Measure.median(times[0])));
            measures.add(Measure.noticedAtMost(
                    "fig3a: first picture whose blur is not noise, error " + FIRST_LOOK,
                    100,
                    "ms",
                    Measure.median(times[2])));
        }
    }

    private static double milliseconds(Renderer renderer, RenderPlan plan, Quality quality)
            throws InterruptedException {
        return renderer.render(plan, quality).report().time().toNanos() / 1e6;
    }

    /**
     * Milliseconds to the first picture of the window that differs from the whole one by no more than wanted; infinite
     * if there is none.
     */
    private static double firstLook(Renderer renderer, RenderPlan plan, LinearImage whole) throws InterruptedException {
        Quality aim = new Quality.Samples(RANDOM_SAMPLES);
        AtomicLong seen = new AtomicLong();
        // the window does not compare
        AtomicLong comparing = new AtomicLong();
        long start = System.nanoTime();
        RenderListener looks = new RenderListener() {
            @Override
            public void passDone(RenderJob job) {
                LinearImage preview = job.preview(aim);
                long now = System.nanoTime();
                if (seen.get() == 0 && PictureDifference.ofLight(preview, whole) <= FIRST_LOOK) {
                    seen.set(now - start - comparing.get());
                    job.cancel();
                }
                comparing.addAndGet(System.nanoTime() - now);
            }
        };
        renderer.startCoarse(plan, aim, looks).await();
        return seen.get() == 0 ? Double.POSITIVE_INFINITY : seen.get() / 1e6;
    }

    private Measure samples() throws InterruptedException {
        double samples;
        LinearImage image;
        try (Renderer renderer = new Renderer()) {
            RenderJob job = renderer.render(RenderPlan.of(studio), new Quality.TargetError(PROMISED));
            image = job.image();
            samples = job.report().samplesPerPixel();
        }
        RenderPlan otherSeed =
                RenderPlan.of(studio.withSettings(studio.settings().withSeed(99)));
        double error = Math.sqrt(mean(pixel -> squaredError(image, otherSeed, pixel)));
        double needed = mean(pixel -> randomVariance(otherSeed, pixel)) / (error * error);
        String what = String.format(
                Locale.ROOT,
                "fig3a, %d x %d, --error %.3f: %.0f samples per pixel, true error %.5f; random ones needed %.0f",
                image.width(),
                image.height(),
                PROMISED,
                samples,
                error,
                needed);
        return Measure.of(what, "x fewer", needed / samples);
    }

    private double mean(IntToDoubleFunction ofPixel) {
        return IntStream.of(pixels).parallel().mapToDouble(ofPixel).average().orElseThrow();
    }

    private double squaredError(LinearImage image, RenderPlan plan, int pixel) {
        SampleTracer tracer = plan.tracer(new RayCounts());
        int column = pixel % image.width();
        int row = pixel / image.width();
        tracer.shareBetween(referenceSamples);
        double[] sums = new double[3];
        for (int sample = 0; sample < referenceSamples; sample++) {
            add(sums, tracer.sample(column, row, sample));
        }
        double squares = 0;
        for (int channel = 0; channel < 3; channel++) {
            double difference = image.value(column, row, channel) - plan.exposure() * sums[channel] / referenceSamples;
            squares += difference * difference / 3;
        }
        return squares;
    }

    /** The variance of one sample at a random place, averaged over the channels; estimated without bias. */
    private double randomVariance(RenderPlan plan, int pixel) {
        SampleTracer tracer = plan.tracer(new RayCounts());
        Random random = new Random(pixel);
        double[] sums = new double[3];
        double squares = 0;
        for (int sample = 0; sample < RANDOM_SAMPLES; sample++) {
            double radius = Math.sqrt(random.nextDouble());
            double angle = 2 * Math.PI * random.nextDouble();
            Colour colour = tracer.sample(
                    pixel % plan.width() + random.nextDouble(),
                    pixel / plan.width() + random.nextDouble(),
                    radius * Math.cos(angle),
                    radius * Math.sin(angle),
                    random.nextDouble());
            add(sums, colour);
            squares += colour.red() * colour.red() + colour.green() * colour.green() + colour.blue() * colour.blue();
        }
        double squaredSums = sums[0] * sums[0] + sums[1] * sums[1] + sums[2] * sums[2];
        return plan.exposure()
                * plan.exposure()
                * (squares - squaredSums / RANDOM_SAMPLES)
                / (3.0 * (RANDOM_SAMPLES - 1));
    }

    private static void add(double[] sums, Colour colour) {
        sums[0] += colour.red();
        sums[1] += colour.green();
        sums[2] += colour.blue();
    }
}
