package tompkins.study;

import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Stream;
import tompkins.camera.EyeView;
import tompkins.camera.PictureRays;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.image.LinearImage;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.studio.Studio;
import tompkins.trace.BlockSamples;
import tompkins.trace.Cancellation;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/** Blocks of a picture, spread evenly over it, whose light can be worked out with any sampler, as the renderer does. */
final class ScenePixels {

    /** All blocks. */
    static final int ALL = Integer.MAX_VALUE;

    private static final int MOST_REFERENCE_SAMPLES = 1 << 17;

    /** Samples of the reference for each pixel; half of them in each half. */
    private int referenceSamples;

    private final double wantedError;
    private final BooleanSupplier cancelled;
    private final RenderPlan plan;
    private final List<Rectangle> blocks = new ArrayList<>();
    private double[] reference;

    /** The root mean square error of the reference, from the difference of its halves. */
    private double floor;

    /**
     * Some blocks of a picture.
     *
     * @param most about how many; {@link #ALL} for all of them
     * @param referenceSamples least number of samples per pixel of the reference
     * @param wantedError the number is doubled until the error of the reference is at most this
     * @param cancelled asked now and then whether to stop
     */
    ScenePixels(Studio studio, int most, int referenceSamples, double wantedError, BooleanSupplier cancelled) {
        plan = RenderPlan.of(studio);
        this.referenceSamples = referenceSamples;
        this.wantedError = wantedError;
        this.cancelled = cancelled;
        int side = RayPacket.SIDE;
        int columns = (plan.width() + side - 1) / side;
        int all = columns * ((plan.height() + side - 1) / side);
        Rectangle picture = new Rectangle(plan.width(), plan.height());
        int step = Math.max(1, all / most);
        for (int number = step / 2; number < all; number += step) {
            Rectangle block = new Rectangle(number % columns * side, number / columns * side, side, side);
            blocks.add(block.intersection(picture));
        }
    }

    /** The space over which the samples of the picture have to be spread. */
    SampledSpace space() {
        boolean time = plan.blursInTime();
        return new SampledSpace(!time || plan.studio().camera().hasWideAperture(), time, true);
    }

    /** How far the light of a sampler is from what it should be, and how long it takes. */
    Figures sampled(Sampler sampler, int samples) {
        double[] right = reference();
        double[][] light = new double[1][];
        double seconds = Race.seconds(() -> light[0] = light(blocks.stream(), block -> light(block, sampler, samples)));
        double rays = (double) samples * right.length / 3;
        return Figures.of(rays, seconds, difference(light[0], right), floor);
    }

    /**
     * How far the light of photographs is from what it should be.
     *
     * @param seed of the first of several runs
     * @throws CancellationException soon after the measurement was cancelled
     */
    Figures photographed(long seed, int runs, Quality quality) {
        double[] right = reference();
        List<Figures> figures = new ArrayList<>();
        for (long run = seed; run < seed + runs; run++) {
            Cancellation.stopIf(cancelled);
            Studio seeded = plan.studio().withSettings(plan.studio().settings().withSeed(run));
            RenderJob job = Photographs.taken(RenderPlan.of(seeded), quality, cancelled);
            RenderReport report = job.report();
            double[] errors = difference(light(blocks.stream(), block -> light(block, job.image())), right);
            figures.add(Figures.of(report.counts().samples, report.time().toNanos() / 1e9, errors, floor));
        }
        return Figures.of(figures);
    }

    /** The light of some pixels, three channels each, from what each block shows. */
    private static double[] light(Stream<Rectangle> blocks, Function<Rectangle, double[]> light) {
        return blocks.map(light).flatMapToDouble(Arrays::stream).toArray();
    }

    private static double[] light(Rectangle block, LinearImage image) {
        double[] light = new double[3 * block.width * block.height];
        Arrays.setAll(light, i -> image.value(block.x + i / 3 % block.width, block.y + i / 3 / block.width, i % 3));
        return light;
    }

    private double[] light(Rectangle block, Sampler sampler, int samples) {
        SampleTracer tracer = plan.tracer(new RayCounts(), sampler);
        tracer.shareBetween(samples);
        double[] light = new double[3 * block.width * block.height];
        PictureRays rays = plan.pictureRays();
        SamplePositions pixels = new SamplePositions(block.width * block.height);
        for (EyeView eye : rays.views()) {
            pixels.begin(eye);
            pixels.addPixels(block.x, block.y, block.width, block.height, 1, (x, y) -> rays.view(x, y) == eye);
            for (int sample = 0; sample < samples; sample++) {
                BlockSamples taken = tracer.sampleBlock(pixels, sample, () -> false);
                for (int i = 0; i < pixels.count(); i++) {
                    int index = 3 * ((pixels.row(i) - block.y) * block.width + pixels.column(i) - block.x);
                    light[index] += taken.red[i];
                    light[index + 1] += taken.green[i];
                    light[index + 2] += taken.blue[i];
                }
            }
        }
        double mean = plan.exposure() / samples;
        return Arrays.stream(light).map(sum -> mean * sum).toArray();
    }

    /** The light of all pixels as it should be; worked out when it is first asked for, by all threads. */
    double[] reference() {
        while (reference == null) {
            double[] one = half(11);
            double[] other = half(12);
            double error = Figures.rootMeanSquare(difference(one, other)) / 2;
            if (error <= wantedError || 2 * referenceSamples > MOST_REFERENCE_SAMPLES) {
                reference = new double[one.length];
                Arrays.setAll(reference, i -> (one[i] + other[i]) / 2);
                floor = error;
            } else {
                referenceSamples *= 2;
            }
        }
        return reference;
    }

    private static double[] difference(double[] one, double[] other) {
        double[] difference = new double[one.length];
        Arrays.setAll(difference, i -> one[i] - other[i]);
        return difference;
    }

    private double[] half(long seed) {
        int samples = Math.max(1, referenceSamples / 2);
        return light(blocks.parallelStream(), block -> {
            Cancellation.stopIf(cancelled);
            return light(block, SamplePattern.lattice(seed, samples), samples);
        });
    }
}
