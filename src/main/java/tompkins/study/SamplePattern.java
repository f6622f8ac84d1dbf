package tompkins.study;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.hipparchus.random.HaltonSequenceGenerator;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.ray.RayPacket;

/**
 * A way to choose positions, at random or from a table that is shifted in each pixel, at work on the blocks of pixels
 * that the renderer follows. Like the program's own sampler, a pattern depends on the seed and the pixel.
 */
final class SamplePattern implements Sampler {

    /** The generating vector of a lattice rule (Cools, Kuo and Nuyens 2006): lens, time (its last number), pixel. */
    private static final long[] GENERATOR = {1, 182667, 110745, 469891, 498753};

    /** The samples of one pixel. */
    @FunctionalInterface
    private interface PixelSamples {

        /** Puts the position of a sample where it belongs; samples come in their order. */
        void go(int sample, Position at);
    }

    private final long seed;
    private final Function<SplittableRandom, PixelSamples> pixels;
    private final PixelSamples[] block = new PixelSamples[RayPacket.MOST];
    private final Position position = new Position();

    /** A pattern that begins each pixel with a generator of its own. */
    private SamplePattern(long seed, Function<SplittableRandom, PixelSamples> pixels) {
        this.seed = seed;
        this.pixels = pixels;
    }

    @Override
    public void choose(SamplePositions positions, int sample) {
        for (int i = 0; i < positions.count(); i++) {
            if (sample == 0) {
                block[i] = pixels.apply(randomFor(positions.columns[i], positions.rows[i]));
            }
            block[i].go(sample, position);
            position.give(positions, i);
        }
    }

    private SplittableRandom randomFor(int column, int row) {
        // the seed itself is not well mixed, but the first number of a generator is
        long mixed = new SplittableRandom(seed * 0x9e3779b97f4a7c15L + ((long) row << 32 | column)).nextLong();
        return new SplittableRandom(mixed);
    }

    /** {@link SamplingMethod#RANDOM}. */
    static SamplePattern independent(long seed, int samples, SampledSpace space) {
        return new SamplePattern(seed, random -> (sample, at) -> {
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
        });
    }

    /** {@link SamplingMethod#JITTERED}; cells of the pixel, the lens and the time are paired at random. */
    static SamplePattern jittered(long seed, int samples, SampledSpace space) {
        int columns = (int) Math.ceil(Math.sqrt(samples));
        int rows = (samples + columns - 1) / columns;
        return new SamplePattern(seed, random -> {
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
        });
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
    static SamplePattern halton(long seed, int samples, SampledSpace space) {
        HaltonSequenceGenerator sequence = new HaltonSequenceGenerator(space.dimensions());
        return shifted(seed, samples, space, i -> sequence.nextVector());
    }

    /** {@link SamplingMethod#ADDITIVE}: steps 1/p, 1/p^2, ..., where p^(d+1) = p + 1 in d dimensions. */
    static SamplePattern additive(long seed, int samples, SampledSpace space) {
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
        return shifted(seed, samples, space, i -> wrapped(last, steps));
    }

    private static double[] wrapped(double[] last, double[] steps) {
        Arrays.setAll(last, i -> wrapped(last[i], steps[i]));
        return last.clone();
    }

    /**
     * The points of references, in all dimensions: a lattice in the order of van der Corput. None of the methods that
     * are compared uses it.
     */
    static SamplePattern lattice(long seed, int samples) {
        return shifted(seed, samples, SampledSpace.ALL, i -> {
            double fraction = (Integer.reverse(i) & 0xffffffffL) * 0x1p-32;
            return Arrays.stream(GENERATOR)
                    .mapToDouble(step -> wrapped(fraction * step, 0))
                    .toArray();
        });
    }

    private static SamplePattern shifted(long seed, int samples, SampledSpace space, IntFunction<double[]> sequence) {
        double[][] points = IntStream.range(0, samples).mapToObj(sequence).toArray(double[][]::new);
        return new SamplePattern(seed, random -> {
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
        });
    }

    /** The sum without its whole part. */
    private static double wrapped(double value, double shift) {
        double sum = value + shift;
        return sum - Math.floor(sum);
    }
}
