package tompkins.render;

/**
 * How hard each pixel is, and so how wrong it still may be. The variance of a pixel's mean is taken to fall as
 * {@code roughness n^-POWER} with the number n of its samples; the roughness is measured where samples are, and shared with
 * the eight neighbours: an edge that no sample of a pixel has met yet has been met next door.
 *
 * <p>Where a pixel has several samples, its roughness is that of the difference between the first and the second half of
 * them. Where it has the one in its centre, it is that of the second differences over its neighbours: an edge of height h
 * raises those of two pixels by h, and is wrong by h/sqrt(12) in one of them.
 */
final class Roughness {

    /** Variance falls with this power: the mean of pixels with edges, sampled over pixel and lens. */
    static final double POWER = 1.25;

    private static final double SHARE_OF_SECOND_DIFFERENCE = 1.0 / 24;

    private final int width;
    private final int height;
    private final float[] shared;
    private final Film film;
    private final int sampled;
    private int lastSamples;
    private double lastExponent;
    private double lastPower;

    /** The roughness of the pixels that have samples. */
    Roughness(Film film) {
        this.film = film;
        width = film.width();
        height = film.height();
        float[] own = new float[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                own[row * width + column] = (float) own(column, row);
            }
        }
        sampled = film.sampledPixels();
        shared = withNeighbours(own);
    }

    /** The roughness that a pixel's own samples show; NaN if it has none. */
    private double own(int column, int row) {
        int samples = film.samples(row * width + column);
        if (samples == 0) {
            return Double.NaN;
        }
        if (samples > 1) {
            return film.halvesVariance(row * width + column) * power(samples, POWER);
        }
        double most = secondDifference(column, row, 1, 0);
        most = Math.max(most, secondDifference(column, row, 0, 1));
        most = Math.max(most, secondDifference(column, row, 1, 1));
        most = Math.max(most, secondDifference(column, row, 1, -1));
        return most * SHARE_OF_SECOND_DIFFERENCE;
    }

    /** The mean square, over the channels, of the second difference along a direction; 0 where a neighbour is missing. */
    private double secondDifference(int column, int row, int right, int down) {
        int before = neighbour(column - right, row - down);
        int after = neighbour(column + right, row + down);
        if (before < 0 || after < 0) {
            return 0;
        }
        int pixel = row * width + column;
        double sum = 0;
        for (int channel = 0; channel < 3; channel++) {
            double difference = film.mean(before, channel) + film.mean(after, channel) - 2 * film.mean(pixel, channel);
            sum += difference * difference;
        }
        return sum / 3;
    }

    private int neighbour(int column, int row) {
        if (column < 0 || row < 0 || column >= width || row >= height) {
            return -1;
        }
        int pixel = row * width + column;
        return film.samples(pixel) > 0 ? pixel : -1;
    }

    private float[] withNeighbours(float[] own) {
        float[] mean = new float[own.length];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                float sum = 0;
                int count = 0;
                for (int y = Math.max(0, row - 1); y <= Math.min(height - 1, row + 1); y++) {
                    for (int x = Math.max(0, column - 1); x <= Math.min(width - 1, column + 1); x++) {
                        float value = own[y * width + x];
                        if (value >= 0) {
                            sum += value;
                            count++;
                        }
                    }
                }
                boolean none = Float.isNaN(own[row * width + column]);
                mean[row * width + column] = none ? 0 : sum / count;
            }
        }
        return mean;
    }

    /** The roughness of a pixel, shared with its neighbours. */
    double of(int pixel) {
        return shared[pixel];
    }

    /** The variance that the mean of a pixel has. */
    double variance(int pixel) {
        int samples = film.samples(pixel);
        return samples <= 1 ? shared[pixel] : shared[pixel] * power(samples, -POWER);
    }

    /** A power, kept for the next pixel, which mostly has as many samples. */
    private double power(int samples, double exponent) {
        if (samples != lastSamples || exponent != lastExponent) {
            lastSamples = samples;
            lastExponent = exponent;
            lastPower = Math.pow(samples, exponent);
        }
        return lastPower;
    }

    /** Number of pixels that have samples. */
    int sampled() {
        return sampled;
    }

    /** The root mean square error of the pixels that have samples, before exposure. */
    double rootMeanSquare() {
        double sum = 0;
        for (int pixel = 0; pixel < shared.length; pixel++) {
            sum += variance(pixel);
        }
        return Math.sqrt(sum / Math.max(1, sampled));
    }
}
