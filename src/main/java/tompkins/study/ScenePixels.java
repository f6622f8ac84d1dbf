package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import tompkins.camera.Sampler;
import tompkins.image.LinearImage;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleSink;
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
    private final List<Block> blocks = new ArrayList<>();
    private int count;
    private double[] reference;

    /** The root mean square error of the reference, from the difference of its halves. */
    private double floor;

    /**
     * A block.
     *
     * @param left first column
     * @param top first row
     * @param width columns
     * @param height rows
     * @param first number of its first pixel among those of all blocks
     */
    private record Block(int left, int top, int width, int height, int first) {

        int place(int column, int row) {
            return first + (row - top) * width + column - left;
        }
    }

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
        int step = Math.max(1, all / most);
        for (int number = step / 2; number < all; number += step) {
            int left = number % columns * side;
            int top = number / columns * side;
            int width = Math.min(side, plan.width() - left);
            int height = Math.min(side, plan.height() - top);
            blocks.add(new Block(left, top, width, height, count));
            count += width * height;
        }
    }

    /** The space over which the samples of the picture have to be spread. */
    SampledSpace space() {
        if (!plan.blursInTime()) {
            return SampledSpace.LENS_AND_PIXEL;
        }
        return plan.studio().camera().hasWideAperture() ? SampledSpace.ALL : SampledSpace.TIME_AND_PIXEL;
    }

    /** How far the light of a sampler is from what it should be, and how long it takes. */
    Figures sampled(Sampler sampler, int samples) {
        double[] right = reference();
        double[][] light = new double[1][];
        double seconds = Stopwatch.seconds(() -> light[0] = light(sampler, samples));
        return Figures.of((double) samples * count, seconds, ErrorNorm.of(light[0], right), floor);
    }

    /**
     * How far the light of photographs is from what it should be; one run for each studio; the studios differ in their
     * seeds.
     *
     * @throws CancellationException soon after the measurement was cancelled
     */
    Figures photographed(List<Studio> studios, Quality quality) {
        return photographed(studios, quality, ErrorNorm::of);
    }

    /** The same for the mean light of the photographs, relative to what it should be. */
    Figures meanLight(List<Studio> studios, Quality quality) {
        return photographed(studios, quality, ErrorNorm::ofMean);
    }

    private Figures photographed(
            List<Studio> studios, Quality quality, BiFunction<double[], double[], ErrorNorm> measure) {
        double[] right = reference();
        List<Figures> runs = new ArrayList<>();
        for (Studio studio : studios) {
            stopIfCancelled();
            RenderJob job = Photographs.taken(RenderPlan.of(studio), quality, cancelled);
            RenderReport report = job.report();
            ErrorNorm norm = measure.apply(light(job.image()), right);
            runs.add(Figures.of(report.samples(), report.time().toNanos() / 1e9, norm, floor));
        }
        return Figures.of(runs);
    }

    /** The light of the blocks of a photograph. */
    private double[] light(LinearImage image) {
        double[] light = new double[3 * count];
        for (Block block : blocks) {
            for (int i = 0; i < block.width * block.height; i++) {
                int column = block.left + i % block.width;
                int row = block.top + i / block.width;
                for (int channel = 0; channel < 3; channel++) {
                    light[3 * block.place(column, row) + channel] = image.value(column, row, channel);
                }
            }
        }
        return light;
    }

    private void stopIfCancelled() {
        if (cancelled.getAsBoolean()) {
            throw new CancellationException();
        }
    }

    /** The light of all pixels, three channels each, from some samples of each. */
    private double[] light(Sampler sampler, int samples) {
        double[] light = new double[3 * count];
        blocks.forEach(block -> addBlock(block, sampler, samples, light));
        return light;
    }

    private void addBlock(Block block, Sampler sampler, int samples, double[] light) {
        SampleTracer tracer = plan.tracer(new RayCounts(), sampler);
        tracer.shareBetween(samples);
        BlockLight sink = new BlockLight(block, light);
        double weights = 0;
        for (int sample = 0; sample < samples; sample++) {
            sink.weight = SamplePattern.weight(sampler, sample);
            weights += sink.weight;
            tracer.sampleBlock(block.left, block.top, block.width, block.height, 1, sample, sink);
        }
        for (int i = 3 * block.first; i < 3 * (block.first + block.width * block.height); i++) {
            light[i] *= plan.exposure() / weights;
        }
    }

    /** Adds up the light of a block. */
    private static final class BlockLight implements SampleSink {

        private final Block block;
        private final double[] light;
        private double weight;

        BlockLight(Block block, double[] light) {
            this.block = block;
            this.light = light;
        }

        @Override
        public void take(int column, int row, Colour colour) {
            int place = 3 * block.place(column, row);
            light[place] += weight * colour.red();
            light[place + 1] += weight * colour.green();
            light[place + 2] += weight * colour.blue();
        }
    }

    /** The light of all pixels as it should be; worked out when it is first asked for. */
    private double[] reference() {
        while (reference == null) {
            double[] one = half(11);
            double[] other = half(12);
            double error = ErrorNorm.of(one, other).rootMeanSquare() / 2;
            if (error <= wantedError || 2 * referenceSamples > MOST_REFERENCE_SAMPLES) {
                reference = mean(one, other);
                floor = error;
            } else {
                referenceSamples *= 2;
            }
        }
        return reference;
    }

    private static double[] mean(double[] one, double[] other) {
        double[] mean = new double[one.length];
        for (int i = 0; i < mean.length; i++) {
            mean[i] = (one[i] + other[i]) / 2;
        }
        return mean;
    }

    private double[] half(long seed) {
        double[] light = new double[3 * count];
        int samples = Math.max(1, referenceSamples / 2);
        blocks.parallelStream().forEach(block -> {
            stopIfCancelled();
            addBlock(block, new SamplePattern(seed, ShiftedPattern.lattice(samples)), samples, light);
        });
        return light;
    }
}
