package tompkins.render;

import java.util.function.BooleanSupplier;
import tompkins.trace.Cancellation;

/**
 * Shares samples among pixels so that their number is least for a given variance. With the variance {@code r n^-p} of a
 * pixel of roughness r, one more sample gains {@code r n^-(p + 1)} (times p); the best is to raise all pixels until
 * that gain is the same threshold everywhere, to {@code n = (r/threshold)^(1/(p + 1))}.
 *
 * <p>Sums over pixels are kept for steps of the gain, an eighth of an octave wide, so that the result of any threshold
 * is known at once.
 */
final class Allocation {

    private static final double POWER = PixelVariance.POWER;
    private static final int STEPS_PER_OCTAVE = 8;
    private static final int OCTAVES = 160;
    private static final int STEPS = OCTAVES * STEPS_PER_OCTAVE;

    private final float[] gains;

    /** The largest gain; the steps lie below it. */
    private final double largest;

    private final double[] variances = new double[STEPS];
    private final double[] samples = new double[STEPS];
    private final double[] wishes = new double[STEPS];

    /** The most samples that the pixels of each step may get in all. */
    private final double[] most = new double[STEPS];

    /**
     * The allocation for what a picture has so far.
     *
     * @param mostSamples pixels with this many get no more
     * @param stopped whether the allocation is no longer wanted
     * @throws java.util.concurrent.CancellationException if it is not
     */
    Allocation(Film film, PixelVariance roughness, int mostSamples, BooleanSupplier stopped) {
        gains = new float[film.width() * film.height()];
        double highest = 0;
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int pixel = film.pixel(0, row); pixel < film.pixel(0, row + 1); pixel++) {
                int count = Math.max(1, film.samples(pixel));
                gains[pixel] = count >= mostSamples ? 0 : (float) (roughness.variance(pixel) / count);
                highest = Math.max(highest, gains[pixel]);
            }
        }
        largest = highest;
        for (int row = 0; row < film.height(); row++) {
            Cancellation.stopIf(stopped);
            for (int pixel = film.pixel(0, row); pixel < film.pixel(0, row + 1); pixel++) {
                int step = step(gains[pixel]);
                variances[step] += roughness.variance(pixel);
                samples[step] += film.samples(pixel);
                if (gains[pixel] > 0) {
                    wishes[step] += Math.pow(roughness.of(pixel), 1 / (POWER + 1));
                    most[step] += mostSamples;
                }
            }
        }
    }

    private int step(double gain) {
        if (!(gain > 0)) {
            return 0;
        }
        double octaves = Math.log(gain / largest) / Math.log(2) + OCTAVES;
        return (int) Math.max(0, Math.min(STEPS - 1, octaves * STEPS_PER_OCTAVE));
    }

    private double threshold(int step) {
        return largest * Math.pow(2, (double) step / STEPS_PER_OCTAVE - OCTAVES);
    }

    /** What one more sample of a pixel gains. */
    double gain(int pixel) {
        return gains[pixel];
    }

    /** The highest threshold that leaves at most a sum of variances; 0, the lowest of all, if there is none. */
    double thresholdForVariance(double limit) {
        double below = 0;
        for (double variance : variances) {
            below += variance;
        }
        double wish = 0;
        for (int step = STEPS - 1; step > 0; step--) {
            below -= variances[step];
            wish += wishes[step];
            if (below + wish * Math.pow(threshold(step), POWER / (POWER + 1)) <= limit) {
                return threshold(step);
            }
        }
        return 0;
    }

    /**
     * The lowest threshold that needs no more than a number of samples, including those taken before; the highest if
     * there is none.
     */
    double thresholdForSamples(double limit) {
        int step = 1;
        while (step < STEPS - 1 && samples(threshold(step)) > limit) {
            step++;
        }
        return threshold(step);
    }

    /** The number of samples at a threshold, including those taken before. */
    double samples(double threshold) {
        double sum = 0;
        for (int step = 0; step < STEPS; step++) {
            sum += threshold(step) >= threshold && wishes[step] > 0
                    ? Math.min(most[step], wishes[step] * Math.pow(threshold, -1 / (POWER + 1)))
                    : samples[step];
        }
        return sum;
    }
}
