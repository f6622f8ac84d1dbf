package tompkins.render;

/**
 * Shares samples among pixels so that their number is least for a given variance. With the variance {@code r n^-p} of a
 * pixel of roughness r, one more sample gains {@code r n^-(p + 1)} (times p); the best is to raise all pixels until that
 * gain is the same threshold everywhere, to {@code n = (r/threshold)^(1/(p + 1))}.
 *
 * <p>Sums over pixels are kept for steps of the gain, an eighth of an octave wide, so that each threshold is judged at once.
 */
final class Allocation {

    private static final double POWER = Roughness.POWER;
    private static final int STEPS_PER_OCTAVE = 8;
    private static final int LEAST_EXPONENT = -120;
    private static final int STEPS = 160 * STEPS_PER_OCTAVE;

    private final float[] gains;
    private final double[] variances = new double[STEPS];
    private final double[] samples = new double[STEPS];
    private final double[] wishes = new double[STEPS];

    /**
     * The allocation for what a picture has so far.
     *
     * @param mostSamples pixels with this many get no more
     */
    Allocation(Film film, Roughness roughness, int mostSamples) {
        gains = new float[film.width() * film.height()];
        for (int pixel = 0; pixel < gains.length; pixel++) {
            int count = Math.max(1, film.samples(pixel));
            double rough = roughness.of(pixel);
            double variance = roughness.variance(pixel);
            double gain = count >= mostSamples ? 0 : variance / count;
            gains[pixel] = (float) gain;
            int step = step(gain);
            variances[step] += variance;
            samples[step] += film.samples(pixel);
            wishes[step] += gain == 0 ? 0 : Math.pow(rough, 1 / (POWER + 1));
        }
    }

    private static int step(double gain) {
        if (!(gain > 0)) {
            return 0;
        }
        double octaves = Math.log(gain) / Math.log(2) - LEAST_EXPONENT;
        return (int) Math.max(0, Math.min(STEPS - 1, octaves * STEPS_PER_OCTAVE));
    }

    private static double threshold(int step) {
        return Math.pow(2, LEAST_EXPONENT + (double) step / STEPS_PER_OCTAVE);
    }

    /** What one more sample of a pixel gains. */
    double gain(int pixel) {
        return gains[pixel];
    }

    /** The highest threshold that leaves a sum of variances; the lowest of all if none does. */
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

    /** The lowest threshold that takes no more than a number of samples, those taken before included. */
    double thresholdForSamples(double limit) {
        for (int step = 1; step < STEPS; step++) {
            if (samples(threshold(step)) <= limit) {
                return threshold(step);
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    /** The number of samples at a threshold, those taken before included. */
    double samples(double threshold) {
        double sum = 0;
        for (int step = 0; step < STEPS; step++) {
            sum += threshold(step) >= threshold && wishes[step] > 0
                    ? wishes[step] * Math.pow(threshold, -1 / (POWER + 1))
                    : samples[step];
        }
        return sum;
    }
}
