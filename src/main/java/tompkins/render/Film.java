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
     * The mean of the samples of each pixel, multiplied by {@code exposure}. Where a pixel has no sample yet, it is
     * interpolated between the four coarse pixels around it, which costs little and halves the error (see the charts of
     * previews in docs/speed-and-accuracy.md).
     */
    LinearImage image(double exposure) {
        float[] rgb = new float[sums.length];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int stride = stride(column, row);
                if (stride == 1) {
                    put(row * width + column, exposure, rgb, row * width + column);
                } else if (stride < Tile.SIZE) {
                    interpolate(column, row, stride, exposure, rgb);
                }
            }
        }
        return new LinearImage(width, height, rgb);
    }

    /**
     * Distance of the coarse pixels around a pixel: the smallest at which the two next to the nearest have samples too, or
     * else at which the nearest has; 1 if the pixel has samples itself.
     */
    private int stride(int column, int row) {
        int nearest = Tile.SIZE;
        for (int stride = 1; stride < Tile.SIZE; stride *= 2) {
            int pixel = coarse(column, row, stride);
            if (samples[pixel] > 0) {
                boolean alone = stride > 1
                        && (isMissing(pixel, pixel % width + stride < width, stride)
                                || isMissing(pixel, pixel / width + stride < height, stride * width));
                if (!alone) {
                    return stride;
                }
                nearest = Math.min(nearest, stride);
            }
        }
        return nearest;
    }

    private boolean isMissing(int pixel, boolean inPicture, int step) {
        return inPicture && samples[pixel + step] == 0;
    }

    private int coarse(int column, int row, int stride) {
        return (row - row % stride) * width + column - column % stride;
    }

    private void interpolate(int column, int row, int stride, double exposure, float[] rgb) {
        int left = coarse(column, row, stride);
        double across = (double) (column % stride) / stride;
        double down = (double) (row % stride) / stride;
        boolean atRight = column - column % stride + stride >= width;
        boolean atBottom = row - row % stride + stride >= height;
        int target = row * width + column;
        put(left, exposure * (1 - across) * (1 - down), rgb, target);
        put(instead(left, atRight ? 0 : stride), exposure * across * (1 - down), rgb, target);
        put(instead(left, atBottom ? 0 : stride * width), exposure * (1 - across) * down, rgb, target);
        put(
                instead(left, (atRight ? 0 : stride) + (atBottom ? 0 : stride * width)),
                exposure * across * down,
                rgb,
                target);
    }

    /** The pixel a step further, or the pixel itself if the other has no sample yet. */
    private int instead(int pixel, int step) {
        return samples[pixel + step] > 0 ? pixel + step : pixel;
    }

    private void put(int source, double factor, float[] rgb, int target) {
        double scale = factor / samples[source];
        rgb[3 * target] += (float) (sums[3 * source] * scale);
        rgb[3 * target + 1] += (float) (sums[3 * source + 1] * scale);
        rgb[3 * target + 2] += (float) (sums[3 * source + 2] * scale);
    }
}
