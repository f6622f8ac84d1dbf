package tompkins.render;

import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import tompkins.trace.Cancellation;

/**
 * Shares samples among pixels so that their number is least for a given variance. With the variance {@code r n^-p} of a
 * pixel of roughness r, one more sample gains {@code r n^-(p + 1)} (times p); the best is to raise all pixels until
 * that gain is the same threshold everywhere, to {@code n = (r/threshold)^(1/(p + 1))}. Thresholds go in steps of an
 * eighth of an octave.
 */
final class Allocation {

    private static final double POWER = PixelVariance.POWER;
    private static final int STEPS_PER_OCTAVE = 8;
    private static final int OCTAVES = 160;
    private static final int STEPS = OCTAVES * STEPS_PER_OCTAVE;

    private final Film film;
    private final BooleanSupplier stopped;
    private final float[] gains;

    /** Of each pixel, {@code r^(1/(p + 1))}. */
    private final float[] wishes;

    /** The largest gain; the steps lie below it. */
    private double largest;

    /** The variance of the pixels that get no more, added up. */
    private double varianceOfFull;

    /**
     * The allocation for what a picture has so far; pixels with {@link AdaptiveSchedule#MOST_SAMPLES} get no more.
     *
     * @param stopped whether the allocation is no longer wanted; all methods throw a
     *     {@link java.util.concurrent.CancellationException} if it is not
     */
    Allocation(Film film, PixelVariance roughness, BooleanSupplier stopped) {
        this.film = film;
        this.stopped = stopped;
        gains = new float[film.pixels()];
        wishes = new float[film.pixels()];
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int pixel = film.pixel(0, row); pixel < film.pixel(0, row + 1); pixel++) {
                int count = Math.max(1, film.samples(pixel));
                double variance = roughness.variance(pixel);
                if (count < AdaptiveSchedule.MOST_SAMPLES) {
                    gains[pixel] = (float) (variance / count);
                    wishes[pixel] = (float) Math.pow(roughness.of(pixel), 1 / (POWER + 1));
                    largest = Math.max(largest, gains[pixel]);
                } else {
                    varianceOfFull += variance;
                }
            }
        }
    }

    /** What one more sample of a pixel gains. */
    double gain(int pixel) {
        return gains[pixel];
    }

    /** The highest threshold that leaves at most a sum of variances; 0, the lowest of all, if there is none. */
    double thresholdForVariance(double limit) {
        int step = highest(each -> variance(threshold(each)) <= limit);
        return step == 0 ? 0 : threshold(step);
    }

    /** The lowest threshold for at most so many samples, with those taken; the highest if there is none. */
    double thresholdForSamples(double limit) {
        return threshold(Math.min(STEPS - 1, 1 + highest(step -> samples(threshold(step)) > limit)));
    }

    /** The highest step for which something holds that holds for all below it; 0 if there is none. */
    private static int highest(IntPredicate holds) {
        int low = 0;
        int high = STEPS;
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

    private double threshold(int step) {
        return largest * Math.pow(2, (double) step / STEPS_PER_OCTAVE - OCTAVES);
    }

    private double variance(double threshold) {
        Cancellation.stopIf(stopped);
        double growth = Math.pow(threshold, POWER / (POWER + 1));
        double sum = varianceOfFull;
        for (int pixel = 0; pixel < gains.length; pixel++) {
            double count = Math.max(1, film.samples(pixel));
            sum += gains[pixel] >= threshold ? wishes[pixel] * growth : gains[pixel] * count;
        }
        return sum;
    }

    /** The number of samples at a threshold, including those taken before. */
    double samples(double threshold) {
        Cancellation.stopIf(stopped);
        double growth = Math.pow(threshold, -1 / (POWER + 1));
        double sum = 0;
        for (int pixel = 0; pixel < gains.length; pixel++) {
            sum += gains[pixel] > 0 && gains[pixel] >= threshold
                    ? Math.min(AdaptiveSchedule.MOST_SAMPLES, wishes[pixel] * growth)
                    : film.samples(pixel);
        }
        return sum;
    }
}
