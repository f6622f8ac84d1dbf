package tompkins.render;

import tompkins.image.LinearImage;
import tompkins.ray.Colour;

/**
 * The light that was collected so far. Each pixel is written by one thread at a time, in the order of its samples, so that
 * the sums are the same whatever the number of threads.
 */
final class Film {

    private final int width;
    private final int height;
    private final float[] sums;
    private final int[] samples;

    /** The sums when a pixel had half of its samples: as many as the greatest power of two below their number. */
    private final float[] halfSums;

    /**
     * A film.
     *
     * @param comparesHalves whether it can tell the variance of pixels with several samples, for twice the memory
     */
    Film(int width, int height, boolean comparesHalves) {
        this.width = width;
        this.height = height;
        sums = new float[Math.multiplyExact(3, width * height)];
        samples = new int[width * height];
        halfSums = comparesHalves ? new float[sums.length] : null;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    void add(int column, int row, Colour colour) {
        int pixel = row * width + column;
        int count = samples[pixel];
        if (halfSums != null && count > 0 && (count & (count - 1)) == 0) {
            System.arraycopy(sums, 3 * pixel, halfSums, 3 * pixel, 3);
        }
        sums[3 * pixel] += (float) colour.red();
        sums[3 * pixel + 1] += (float) colour.green();
        sums[3 * pixel + 2] += (float) colour.blue();
        samples[pixel]++;
    }

    /** Whether {@link #halvesVariance} can be asked. */
    boolean comparesHalves() {
        return halfSums != null;
    }

    /** Takes the samples of a pixel away. */
    void restart(int pixel) {
        samples[pixel] = 0;
        sums[3 * pixel] = 0;
        sums[3 * pixel + 1] = 0;
        sums[3 * pixel + 2] = 0;
    }

    /** Number of samples of a pixel. */
    int samples(int pixel) {
        return samples[pixel];
    }

    /** The mean of a channel of a pixel that has samples. */
    double mean(int pixel, int channel) {
        return (double) sums[3 * pixel + channel] / samples[pixel];
    }

    /**
     * The variance of the mean of a pixel with two samples or more, averaged over the channels: for n = a + b samples it is
     * {@code D^2 a b/n^2}, where D is the difference between the means of the first a and of the other b.
     */
    double halvesVariance(int pixel) {
        int count = samples[pixel];
        int first = Integer.highestOneBit(count - 1);
        double sum = 0;
        for (int channel = 0; channel < 3; channel++) {
            double half = halfSums[3 * pixel + channel];
            double difference = half / first - (sums[3 * pixel + channel] - half) / (count - first);
            sum += difference * difference;
        }
        return sum / 3 * first * (count - first) / ((double) count * count);
    }

    /**
     * The mean of the samples of each pixel, multiplied by {@code exposure}. Where a pixel has no sample yet, that of the
     * nearest coarse pixel above and to the left is shown.
     */
    LinearImage image(double exposure) {
        float[] rgb = new float[sums.length];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int pixel = row * width + column;
                int source = source(column, row);
                if (samples[source] > 0) {
                    double scale = exposure / samples[source];
                    rgb[3 * pixel] = (float) (sums[3 * source] * scale);
                    rgb[3 * pixel + 1] = (float) (sums[3 * source + 1] * scale);
                    rgb[3 * pixel + 2] = (float) (sums[3 * source + 2] * scale);
                }
            }
        }
        return new LinearImage(width, height, rgb);
    }

    private int source(int column, int row) {
        int pixel = row * width + column;
        for (int stride = 1; samples[pixel] == 0 && stride < Tile.SIZE; stride *= 2) {
            pixel = (row - row % stride) * width + column - column % stride;
        }
        return pixel;
    }
}
