package tompkins.render;

import java.util.Arrays;
import tompkins.image.LinearImage;

/**
 * The light that has been collected so far. Each pixel is written by one thread at a time, in the order of its samples,
 * so that the sums are the same whatever the number of threads.
 */
final class Film {

    /** Marks a pixel whose only sample is replaced by the next one. */
    private static final int REPLACED = -1;

    private final int width;
    private final int height;
    private final double exposure;
    private final float[] sums;
    private final int[] samples;

    /** The sums at the time when a pixel had half of its samples: the greatest power of two below their number. */
    private final float[] halfSums;

    /**
     * A film.
     *
     * @param exposure factor of all light in its pictures and variances
     * @param comparesHalves whether it can estimate the variance of pixels with several samples, which takes more
     *     memory
     */
    Film(int width, int height, double exposure, boolean comparesHalves) {
        this.width = width;
        this.height = height;
        this.exposure = exposure;
        sums = new float[Math.multiplyExact(3, width * height)];
        samples = new int[width * height];
        halfSums = comparesHalves ? new float[sums.length] : null;
    }

    /** The memory that a film takes. */
    static int bytesPerPixel(boolean comparesHalves) {
        int sums = 3 * Float.BYTES;
        return Integer.BYTES + (comparesHalves ? 2 * sums : sums);
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** The number of a pixel: row by row, from 0. */
    int pixel(int column, int row) {
        return row * width + column;
    }

    /**
     * Whether this number of samples is the first half of those to come; the next samples of the pixel must then be
     * added separately.
     */
    static boolean isNewHalf(int samples) {
        return Integer.bitCount(samples) == 1;
    }

    /** Adds the sum of one or more samples of a pixel. They do not go beyond a {@link #isNewHalf new half}. */
    void add(int pixel, double red, double green, double blue, int added) {
        int count = samples[pixel];
        if (count == REPLACED) {
            Arrays.fill(sums, 3 * pixel, 3 * pixel + 3, 0);
            samples[pixel] = 0;
        } else if (halfSums != null && isNewHalf(count)) {
            System.arraycopy(sums, 3 * pixel, halfSums, 3 * pixel, 3);
        }
        sums[3 * pixel] = (float) (sums[3 * pixel] + red);
        sums[3 * pixel + 1] = (float) (sums[3 * pixel + 1] + green);
        sums[3 * pixel + 2] = (float) (sums[3 * pixel + 2] + blue);
        samples[pixel] += added;
    }

    /** Whether {@link #halvesVariance} can be asked. */
    boolean comparesHalves() {
        return halfSums != null;
    }

    /** Lets the next sample of a pixel replace the only one that it has. */
    void restart(int pixel) {
        samples[pixel] = REPLACED;
    }

    /** Number of samples of a pixel. */
    int samples(int pixel) {
        return Math.abs(samples[pixel]);
    }

    /** Number of pixels that have samples. */
    int sampledPixels() {
        return (int) Arrays.stream(samples).filter(count -> count != 0).count();
    }

    /**
     * Writes the means of a row, channel by channel, behind the first pixel of an array; NaN where there are no
     * samples.
     */
    void means(int row, double[] into) {
        for (int column = 0; column < width; column++) {
            int pixel = pixel(column, row);
            int count = samples(pixel);
            for (int channel = 0; channel < 3; channel++) {
                into[3 * (column + 1) + channel] = exposure * sums[3 * pixel + channel] / count;
            }
        }
    }

    /**
     * The variance of the mean of a pixel with two samples or more, averaged over the channels: for n = a + b samples
     * it is {@code D^2 a b/n^2}, where D is the difference between the means of the first a and of the other b.
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
        return exposure * exposure * sum / 3 * first * (count - first) / ((double) count * count);
    }

    /**
     * The mean of the samples of each pixel. Between coarse pixels it is interpolated, which costs little and takes a
     * third of the error away (see the charts of previews in docs/speed-and-accuracy.md).
     */
    LinearImage image() {
        float[] rgb = new float[sums.length];
        int stride = completeStride();
        if (stride > 1 && stride < Tile.SIZE) {
            interpolate(stride, rgb);
        }
        for (int pixel = 0; pixel < samples.length; pixel++) {
            if (samples[pixel] != 0) {
                put(pixel, rgb, 3 * pixel);
            }
        }
        return new LinearImage(width, height, rgb);
    }

    /** The smallest distance at which all pixels have samples; {@link Tile#SIZE} if there is none. */
    private int completeStride() {
        int stride = 1;
        while (stride < Tile.SIZE && !isComplete(stride)) {
            stride *= 2;
        }
        return stride;
    }

    private boolean isComplete(int stride) {
        for (int row = 0; row < height; row += stride) {
            for (int column = 0; column < width; column += stride) {
                if (samples[pixel(column, row)] == 0) {
                    return false;
                }
            }
        }
        return true;
    }

    private void interpolate(int stride, float[] rgb) {
        float[] upper = coarseRow(0, stride);
        for (int top = 0; top < height; top += stride) {
            float[] lower = top + stride < height ? coarseRow(top + stride, stride) : upper;
            for (int row = top; row < Math.min(height, top + stride); row++) {
                float down = (float) (row - top) / stride;
                int start = 3 * row * width;
                for (int i = 0; i < upper.length; i++) {
                    rgb[start + i] = upper[i] + down * (lower[i] - upper[i]);
                }
            }
            upper = lower;
        }
    }

    /** One row, interpolated between its coarse pixels. */
    private float[] coarseRow(int row, int stride) {
        float[] light = new float[3 * width];
        for (int column = 0; column < width; column += stride) {
            put(pixel(column, row), light, 3 * column);
        }
        for (int column = 0; column < width; column++) {
            int left = column - column % stride;
            int right = left + stride < width ? left + stride : left;
            float across = (float) (column - left) / stride;
            for (int channel = 0; channel < 3; channel++) {
                float first = light[3 * left + channel];
                light[3 * column + channel] = first + across * (light[3 * right + channel] - first);
            }
        }
        return light;
    }

    private void put(int pixel, float[] light, int place) {
        int count = samples(pixel);
        // most pictures of a window have one sample, which needs no division
        double scale = count == 1 ? exposure : exposure / count;
        for (int channel = 0; channel < 3; channel++) {
            // light is finite, but exposure may lift it above what a picture can hold
            light[place + channel] = (float) Math.min(Float.MAX_VALUE, sums[3 * pixel + channel] * scale);
        }
    }
}
