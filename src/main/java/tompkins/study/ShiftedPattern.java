package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.hipparchus.random.HaltonSequenceGenerator;

/** The points of one sequence for all pixels, shifted in each by another vector. */
final class ShiftedPattern extends SamplePattern {

    private final double[][] points;
    private final double[] shift;
    private final boolean pixelToo;

    private ShiftedPattern(long seed, int samples, boolean pixelToo, Supplier<double[]> sequence) {
        super(seed);
        this.pixelToo = pixelToo;
        shift = new double[pixelToo ? 4 : 2];
        points = new double[samples][];
        for (int i = 0; i < samples; i++) {
            points[i] = sequence.get();
        }
    }

    /** {@link SamplingMethod#HALTON}. */
    static ShiftedPattern halton(long seed, int samples, boolean pixelToo) {
        return new ShiftedPattern(seed, samples, pixelToo, new HaltonSequenceGenerator(pixelToo ? 4 : 2)::nextVector);
    }

    /** {@link SamplingMethod#ADDITIVE}: steps 1/p, 1/p^2, ..., where p^(d+1) = p + 1 in d dimensions. */
    static ShiftedPattern additive(long seed, int samples, boolean pixelToo) {
        int dimensions = pixelToo ? 4 : 2;
        double base = 1;
        for (int i = 0; i < 60; i++) {
            base = Math.pow(1 + base, 1.0 / (dimensions + 1));
        }
        double[] steps = new double[dimensions];
        for (int i = 0; i < dimensions; i++) {
            steps[i] = Math.pow(base, -i - 1);
        }
        double[] last = new double[dimensions];
        return new ShiftedPattern(seed, samples, pixelToo, () -> {
            for (int i = 0; i < dimensions; i++) {
                last[i] = wrapped(last[i], steps[i]);
            }
            return last.clone();
        });
    }

    @Override
    void startPixel(int column, int row) {
        SplittableRandom random = randomFor(column, row);
        for (int i = 0; i < shift.length; i++) {
            shift[i] = random.nextDouble();
        }
    }

    @Override
    void goTo(int sample) {
        double[] point = points[sample];
        lens(wrapped(point[0], shift[0]), wrapped(point[1], shift[1]));
        if (pixelToo) {
            x = wrapped(point[2], shift[2]);
            y = wrapped(point[3], shift[3]);
        }
    }
}
