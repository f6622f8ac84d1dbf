package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.hipparchus.random.HaltonSequenceGenerator;

/** The positions that the methods choose in a pixel: at random, or from a table that is shifted or turned in each. */
final class SamplePatterns {

    /** The generating vector of a lattice rule (Cools, Kuo and Nuyens 2006): lens, time (its last number), pixel. */
    private static final long[] GENERATOR = {1, 182667, 110745, 469891, 498753};

    private SamplePatterns() {}

    /** {@link SamplingMethod#RANDOM}. */
    static SamplePattern.Pixels independent(SampledSpace space) {
        return random -> (sample, at) -> {
            if (space.hasPixel()) {
                at.x = random.nextDouble();
                at.y = random.nextDouble();
            }
            if (space.hasTime()) {
                at.moment = random.nextDouble();
            }
            if (space.hasLens()) {
                do {
                    at.lensX = 2 * random.nextDouble() - 1;
                    at.lensY = 2 * random.nextDouble() - 1;
                } while (at.lensX * at.lensX + at.lensY * at.lensY > 1);
            }
        };
    }

    /** {@link SamplingMethod#JITTERED}; cells of the pixel, the lens and the time are paired at random. */
    static SamplePattern.Pixels jittered(int samples, SampledSpace space) {
        int columns = (int) Math.ceil(Math.sqrt(samples));
        int rows = (samples + columns - 1) / columns;
        return random -> {
            int[] cells = space.hasPixel() ? shuffled(samples, random) : null;
            int[] moments = space.hasTime() ? shuffled(samples, random) : null;
            return (sample, at) -> {
                if (space.hasLens()) {
                    double across = (sample % columns + random.nextDouble()) / columns;
                    at.goToLens(across, (sample / columns + random.nextDouble()) / rows);
                }
                if (moments != null) {
                    at.moment = (moments[sample] + random.nextDouble()) / samples;
                }
                if (cells != null) {
                    at.x = (cells[sample] % columns + random.nextDouble()) / columns;
                    at.y = (cells[sample] / columns + random.nextDouble()) / rows;
                }
            };
        };
    }

    /** The numbers from 0 to below {@code count} in random order. */
    private static int[] shuffled(int count, SplittableRandom random) {
        int[] order = new int[count];
        for (int i = 0; i < count; i++) {
            int j = random.nextInt(i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }

    /** {@link SamplingMethod#HALTON}. */
    static SamplePattern.Pixels halton(int samples, SampledSpace space) {
        HaltonSequenceGenerator sequence = new HaltonSequenceGenerator(space.dimensions());
        return shifted(samples, space, i -> sequence.nextVector());
    }

    /** {@link SamplingMethod#ADDITIVE}: steps 1/p, 1/p^2, ..., where p^(d+1) = p + 1 in d dimensions. */
    static SamplePattern.Pixels additive(int samples, SampledSpace space) {
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
        return shifted(samples, space, i -> wrapped(last, steps));
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
    static SamplePattern.Pixels lattice(int samples) {
        return shifted(samples, SampledSpace.ALL, i -> {
            double[] point = new double[GENERATOR.length];
            for (int dimension = 0; dimension < point.length; dimension++) {
                point[dimension] = wrapped((Integer.reverse(i) & 0xffffffffL) * 0x1p-32 * GENERATOR[dimension], 0);
            }
            return point;
        });
    }

    private static SamplePattern.Pixels shifted(int samples, SampledSpace space, IntFunction<double[]> sequence) {
        double[][] points = IntStream.range(0, samples).mapToObj(sequence).toArray(double[][]::new);
        return random -> {
            double[] shift = random.doubles(space.dimensions()).toArray();
            return (sample, at) -> {
                double[] point = points[sample];
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
            };
        };
    }

    /** The sum without its whole part. */
    private static double wrapped(double value, double shift) {
        double sum = value + shift;
        return sum - Math.floor(sum);
    }
}
