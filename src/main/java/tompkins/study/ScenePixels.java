package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import tompkins.ray.Colour;
import tompkins.ray.RayCounts;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;

/** Pixels of a picture, spread evenly over it, whose light can be worked out with any pattern of samples. */
final class ScenePixels {

    static final int ALL = Integer.MAX_VALUE;

    private static final int MOST_REFERENCE_SAMPLES = 1 << 17;

    /** Samples of the reference for each pixel; half of them in each half. */
    private int referenceSamples;

    private final double wantedError;
    private final BooleanSupplier cancelled;
    private final RenderPlan plan;
    private final int stride;
    private final int columns;
    private final int rows;
    private final double exposure;
    private double[] reference;

    /** The root mean square error of the reference, from the difference of its halves. */
    private double floor;

    /**
     * Some pixels of a picture.
     *
     * @param pixels about how many; {@link #ALL} for all of them
     * @param referenceSamples least number of samples per pixel of the reference
     * @param wantedError the number is doubled until the error of the reference is at most this
     * @param cancelled asked now and then whether to stop
     */
    ScenePixels(Studio studio, int pixels, int referenceSamples, double wantedError, BooleanSupplier cancelled) {
        plan = RenderPlan.of(studio);
        this.referenceSamples = referenceSamples;
        this.wantedError = wantedError;
        this.cancelled = cancelled;
        stride = (int) Math.max(1, Math.sqrt((double) plan.width() * plan.height() / pixels));
        columns = (plan.width() + stride - 1) / stride;
        rows = (plan.height() + stride - 1) / stride;
        exposure = plan.exposure();
    }

    /** The space over which the samples of the picture have to be spread. */
    SampledSpace space() {
        if (!plan.blursInTime()) {
            return SampledSpace.LENS_AND_PIXEL;
        }
        return plan.studio().camera().hasWideAperture() ? SampledSpace.ALL : SampledSpace.TIME_AND_PIXEL;
    }

    private int count() {
        return columns * rows;
    }

    /** How far the light of patterns is from what it should be; one run for each pattern. */
    Figures placed(List<SamplePattern> patterns, int samples) {
        double[] right = reference();
        List<Figures> runs = new ArrayList<>();
        for (SamplePattern pattern : patterns) {
            long start = System.nanoTime();
            double[] light = light(pattern, samples);
            double seconds = (System.nanoTime() - start) / 1e9;
            runs.add(Figures.of((double) samples * count(), seconds, ErrorNorm.of(light, right), floor));
        }
        return Figures.of(runs);
    }

    /**
     * How far the light of photographs is from what it should be; one run for each studio; the studios differ in their
     * seeds.
     *
     * @throws CancellationException soon after the measurement was cancelled
     */
    Figures photographed(List<Studio> studios, Quality quality) {
        double[] right = reference();
        List<Figures> runs = new ArrayList<>();
        for (Studio studio : studios) {
            stopIfCancelled();
            RenderJob job = Photographs.taken(RenderPlan.of(studio), quality, cancelled);
            RenderReport report = job.report();
            ErrorNorm norm = ErrorNorm.of(Photographs.light(job.image()), right);
            runs.add(Figures.of(report.samples(), report.time().toNanos() / 1e9, norm, floor));
        }
        return Figures.of(runs);
    }

    private void stopIfCancelled() {
        if (cancelled.getAsBoolean()) {
            throw new CancellationException();
        }
    }

    /** The light of all pixels, three channels each, from some samples of a pattern. */
    double[] light(SamplePattern pattern, int samples) {
        double[] light = new double[3 * count()];
        SampleTracer tracer = plan.tracer(new RayCounts());
        for (int row = 0; row < rows; row++) {
            addRow(row, pattern, tracer, samples, light);
        }
        return light;
    }

    private void addRow(int row, SamplePattern pattern, SampleTracer tracer, int samples, double[] light) {
        tracer.shareBetween(samples);
        int y = Math.min(row * stride + stride / 2, plan.height() - 1);
        for (int column = 0; column < columns; column++) {
            int x = Math.min(column * stride + stride / 2, plan.width() - 1);
            pattern.startPixel(x, y);
            double weights = 0;
            int place = 3 * (row * columns + column);
            for (int sample = 0; sample < samples; sample++) {
                pattern.goTo(sample);
                Colour colour =
                        tracer.sample(x + pattern.x, y + pattern.y, pattern.lensX, pattern.lensY, pattern.moment);
                weights += pattern.weight;
                light[place] += pattern.weight * colour.red();
                light[place + 1] += pattern.weight * colour.green();
                light[place + 2] += pattern.weight * colour.blue();
            }
            for (int channel = 0; channel < 3; channel++) {
                light[place + channel] *= exposure / weights;
            }
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
        double[] light = new double[3 * count()];
        IntStream.range(0, rows).parallel().forEach(row -> {
            stopIfCancelled();
            addRow(
                    row,
                    new LatticePattern(seed),
                    plan.tracer(new RayCounts()),
                    Math.max(1, referenceSamples / 2),
                    light);
        });
        return light;
    }
}
