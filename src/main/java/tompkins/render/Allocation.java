package tompkins.render;

import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import tompkins.trace.Cancellation;

/**
 * Shares samples among pixels so that their number is least for a given variance. With the variance {@code r n^-p} of a
 * pixel of roughness r, one more sample gains {@code r n^-(p + 1)} (times p); the best is to raise all pixels until
 * that gain is the same threshold everywhere. A pixel whose gain is g times the threshold gets {@code g^(1/(p + 1))}
 * times its samples, but at least twice as many, since rounds double them. Gains go in levels, eight for each factor of
 * two.
 */
final class Allocation {

    private static final double POWER = PixelVariance.POWER;

    /** A level is the exponent of a gain in single precision, and the first three bits of its fraction. */
    private static final int BITS_BELOW_LEVEL = 20;

    /** Pixels at the lowest level, 0, gain nothing. */
    private static final int LEVELS = 1 << Integer.SIZE - 1 - BITS_BELOW_LEVEL;

    private static final double LEAST_GROWTH = 2;

    private final short[] levels;
    private final double[] variances = new double[LEVELS];
    private final double[] samples = new double[LEVELS];
    private int highestLevel = 1;

    /**
     * The allocation for what a picture has so far; pixels with {@link AdaptiveSchedule#MOST_SAMPLES} get no more.
     *
     * @param stopped whether the allocation is no longer wanted
     * @throws java.util.concurrent.CancellationException if it is not
     */
    Allocation(Film film, PixelVariance roughness, BooleanSupplier stopped) {
        levels = new short[film.pixels()];
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int pixel = film.pixel(0, row); pixel < film.pixel(0, row + 1); pixel++) {
                int count = Math.max(1, film.samples(pixel));
                double variance = roughness.variance(pixel);
                double gain = count < AdaptiveSchedule.MOST_SAMPLES ? variance / count : 0;
                int level = Float.floatToIntBits((float) gain) >> BITS_BELOW_LEVEL;
                levels[pixel] = (short) level;
                variances[level] += variance;
                samples[level] += film.samples(pixel);
                highestLevel = Math.max(highestLevel, level);
            }
        }
    }

    /** The level of what one more sample of a pixel gains. */
    int level(int pixel) {
        return levels[pixel];
    }

    /** The highest threshold that leaves at most a sum of variances; 1, the lowest of all, if there is none. */
    int thresholdForVariance(double limit) {
        return highest(threshold -> variance(threshold) <= limit);
    }

    /** The lowest threshold for at most so many samples, with those taken; the highest if there is none. */
    int thresholdForSamples(double limit) {
        return Math.min(highestLevel, 1 + highest(threshold -> samples(threshold) > limit));
    }

    /** The highest threshold for which something holds that holds for all below it; 1 if there is none. */
    private static int highest(IntPredicate holds) {
        int low = 1;
        int high = LEVELS;
        while (high - low > 1) {
            int middle = (low + high) / 2;
            if (holds.test(middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private double variance(int threshold) {
        double sum = 0;
        for (int level = 0; level <= highestLevel; level++) {
            sum += variances[level] * Math.pow(growth(level, threshold), -POWER);
        }
        return sum;
    }

    /** The number of samples at a threshold, including those taken before. */
    double samples(int threshold) {
        double sum = 0;
        for (int level = 0; level <= highestLevel; level++) {
            sum += samples[level] * growth(level, threshold);
        }
        return Math.min(sum, (double) AdaptiveSchedule.MOST_SAMPLES * levels.length);
    }

    /** How many times as many samples the pixels of a level get. */
    private static double growth(int level, int threshold) {
        return level < threshold ? 1 : Math.max(LEAST_GROWTH, Math.pow(gain(level) / gain(threshold), 1 / (POWER + 1)));
    }

    private static double gain(int level) {
        return Float.intBitsToFloat(level << BITS_BELOW_LEVEL);
    }
}
