package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.hipparchus.random.HaltonSequenceGenerator;

/** The points of one sequence for all pixels, shifted in each by another vector. */
final class ShiftedPattern extends SamplePattern {

    private final double[][] points;
    private final double[] shift;
    private final SampledSpace space;

    private ShiftedPattern(long seed, int samples, SampledSpace space, Supplier<double[]> sequence) {
        super(seed);
        this.space = space;
        shift = new double[space.dimensions()];
        points = new double[samples][];
        for (int i = 0; i < samples; i++) {
            points[i] = sequence.get();
        }
    }

    /** {@link SamplingMethod#HALTON}. */
    static ShiftedPattern halton(long seed, int samples, SampledSpace space) {
        return new ShiftedPattern(seed, samples, space, new HaltonSequenceGenerator(space.dimensions())::nextVector);
    }

    /** {@link SamplingMethod#ADDITIVE}: steps 1/p, 1/p^2, ..., where p^(d+1) = p + 1 in d dimensions. */
    static ShiftedPattern additive(long seed, int samples, SampledSpace space) {
        int dimensions = space.dimensions();
        double base = 1;
        for (int i = 0; i < 60; i++) {
            base = Math.pow(1 + base, 1.0 / (dimensions + 1));
        }
        double[] steps = new double[dimensions];
        for (int i = 0; i < dimensions; i++) {
            steps[i] = Math.pow(base, -i - 1);
        }
        double[] last = new double[dimensions];
        return new ShiftedPattern(seed, samples, space, () -> {
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
        int next = 0;
        if (space.hasLens()) {
            lens(wrapped(point[0], shift[0]), wrapped(point[1], shift[1]));
            next = 2;
        }
        if (space.hasTime()) {
            moment = wrapped(point[next], shift[next]);
            next++;
        }
        if (space.hasPixel()) {
            x = wrapped(point[next], shift[next]);
            y = wrapped(point[next + 1], shift[next + 1]);
        }
    }
}
