package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.IntFunction;
import org.hipparchus.random.HaltonSequenceGenerator;

/** The points of one sequence for all pixels, shifted in each by another vector. */
final class ShiftedPattern extends SamplePattern {

    /** The generating vector of a lattice rule (Cools, Kuo and Nuyens 2006): lens, time (its last number), pixel. */
    private static final long[] GENERATOR = {1, 182667, 110745, 469891, 498753};

    private final double[][] points;
    private final double[][] shifts;
    private final SampledSpace space;

    private ShiftedPattern(long seed, int samples, SampledSpace space, IntFunction<double[]> sequence) {
        super(seed);
        this.space = space;
        shifts = new double[PIXELS][space.dimensions()];
        points = new double[samples][];
        for (int i = 0; i < samples; i++) {
            points[i] = sequence.apply(i);
        }
    }

    /** {@link SamplingMethod#HALTON}. */
    static ShiftedPattern halton(long seed, int samples, SampledSpace space) {
        HaltonSequenceGenerator sequence = new HaltonSequenceGenerator(space.dimensions());
        return new ShiftedPattern(seed, samples, space, i -> sequence.nextVector());
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
        return new ShiftedPattern(seed, samples, space, i -> wrapped(last, steps));
    }

    private static double[] wrapped(double[] last, double[] steps) {
        for (int i = 0; i < last.length; i++) {
            last[i] = wrapped(last[i], steps[i]);
        }
        return last.clone();
    }

    /**
     * The points of references, in all dimensions: a lattice in the order of van der Corput. None of the methods that
     * are compared uses it.
     */
    static ShiftedPattern lattice(long seed, int samples) {
        return new ShiftedPattern(seed, samples, SampledSpace.ALL, i -> {
            double[] point = new double[GENERATOR.length];
            for (int dimension = 0; dimension < point.length; dimension++) {
                point[dimension] = wrapped((Integer.reverse(i) & 0xffffffffL) * 0x1p-32 * GENERATOR[dimension], 0);
            }
            return point;
        });
    }

    @Override
    void start(int pixel, SplittableRandom random) {
        double[] shift = shifts[pixel];
        for (int i = 0; i < shift.length; i++) {
            shift[i] = random.nextDouble();
        }
    }

    @Override
    void go(int pixel, int sample, Position at) {
        double[] point = points[sample];
        double[] shift = shifts[pixel];
        int next = 0;
        if (space.hasLens()) {
            at.goToLens(wrapped(point[0], shift[0]), wrapped(point[1], shift[1]));
            next = 2;
        }
        if (space.hasTime()) {
            at.moment = wrapped(point[next], shift[next]);
            next++;
        }
        if (space.hasPixel()) {
            at.x = wrapped(point[next], shift[next]);
            at.y = wrapped(point[next + 1], shift[next + 1]);
        }
    }
}
