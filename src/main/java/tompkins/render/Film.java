package tompkins.render;

import java.util.Arrays;
import java.util.stream.IntStream;
import tompkins.image.LinearImage;

/**
 * The light that has been collected so far. Each pixel is written by one thread at a time, in the order of its samples,
 * so that the sums are the same whatever the number of threads.
 */
final class Film extends PixelBuffer {

    /** Marks a pixel whose only sample is replaced by the next one. */
    private static final int REPLACED = -1;

    /** Sums in single precision cannot tell a smaller variance from none, as a fraction of the square of the mean. */
    private static final double ROUNDING = 1e-6;

    private final float[] sums;
    private final int[] samples;

    /** The sums at the time when a pixel had half of its samples: the greatest power of two below their number. */
    private final float[] halfSums;

    /** The sums of the squares of all three channels of the samples. */
    private final float[] squares;

    /**
     * A film.
     *
     * @param exposure factor of all light in its pictures and variances
     * @param comparesSamples whether it can estimate the variance of pixels with several samples, which takes more
     *     memory
     */
    Film(int width, int height, double exposure, boolean comparesSamples) {
        super(width, height, exposure);
        sums = new float[Math.multiplyExact(3, width * height)];
        samples = new int[width * height];
        halfSums = comparesSamples ? new float[sums.length] : null;
        squares = comparesSamples ? new float[samples.length] : null;
    }

    /** The memory that a film takes. */
    static int bytesPerPixel(boolean comparesSamples) {
        int sums = 3 * Float.BYTES;
        return Integer.BYTES + sums + (comparesSamples ? sums + Float.BYTES : 0);
    }

    /** Whether this many samples are the first half of those to come, which must be added separately. */
    static boolean isNewHalf(int samples) {
        return Integer.bitCount(samples) == 1;
    }

    /** As {@link PixelBuffer#add}; they do not go beyond a {@link #isNewHalf new half}. */
    @Override
    void add(int pixel, double red, double green, double blue, double squared, int added) {
        int count = samples[pixel];
        if (count == REPLACED) {
            Arrays.fill(sums, 3 * pixel, 3 * pixel + 3, 0);
            samples[pixel] = 0;
            if (squares != null) {
                squares[pixel] = 0;
            }
        } else if (halfSums != null && isNewHalf(count)) {
            System.arraycopy(sums, 3 * pixel, halfSums, 3 * pixel, 3);
        }
        sums[3 * pixel] = (float) (sums[3 * pixel] + red);
        sums[3 * pixel + 1] = (float) (sums[3 * pixel + 1] + green);
        sums[3 * pixel + 2] = (float) (sums[3 * pixel + 2] + blue);
        samples[pixel] += added;
        if (squares != null) {
            squares[pixel] = (float) Math.min(Float.MAX_VALUE, squares[pixel] + squared);
        }
    }

    /** The sum of the squares of the channels of a sample. */
    static double squared(double red, double green, double blue) {
        return red * red + green * green + blue * blue;
    }

    /** Whether {@link #halvesVariance} and {@link #sampleVariance} can be asked. */
    boolean comparesSamples() {
        return halfSums != null;
    }

    /** Lets the next sample of a pixel replace the only one that it has. */
    void restart(int pixel) {
        samples[pixel] = REPLACED;
    }

    @Override
    int samples(int pixel) {
        return Math.abs(samples[pixel]);
    }

    /** The mean of a channel of a pixel; NaN where there are no samples, and outside of the picture. */
    double mean(int column, int row, int channel) {
        if (column < 0 || row < 0 || column >= width() || row >= height()) {
            return Double.NaN;
        }
        int pixel = pixel(column, row);
        return exposure() * sums[3 * pixel + channel] / samples(pixel);
    }

    /**
     * The variance of a pixel's mean from two or more independent samples, averaged over the channels: for n = a + b of
     * them it is {@code D^2 a b/n^2}, where D is the difference between the means of the first a and of the other b.
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
        return exposure() * exposure() * sum / 3 * first * (count - first) / ((double) count * count);
    }

    /** The variance of single samples of a pixel that has two or more, averaged over the channels. */
    double sampleVariance(int pixel) {
        int count = samples[pixel];
        double ofMean = squared(sums[3 * pixel], sums[3 * pixel + 1], sums[3 * pixel + 2]) / count;
        double variance = squares[pixel] - (1 + ROUNDING) * ofMean;
        return exposure() * exposure() * Math.max(0, variance) / (3 * (count - 1));
    }

    /**
     * The picture in linear light: the mean of the samples of each pixel. Between coarse pixels it is interpolated,
     * which costs little and takes a third of the error away (see the charts of previews in
     * docs/speed-and-accuracy.md).
     */
    LinearImage image() {
        return interpolated(completeStride(), means());
    }

    /** The mean of the samples of each pixel, channel by channel; 0 where there are none. */
    float[] means() {
        float[] rgb = new float[sums.length];
        IntStream.range(0, height()).parallel().forEach(row -> {
            for (int pixel = pixel(0, row); pixel < pixel(0, row + 1); pixel++) {
                if (samples[pixel] != 0) {
                    put(pixel, rgb);
                }
            }
        });
        return rgb;
    }

    /** The picture of such means, which changes those of pixels without samples, between the pixels at a distance. */
    LinearImage interpolated(int stride, float[] rgb) {
        if (stride < Tile.SIZE) {
            for (int step = stride / 2; step > 0; step /= 2) {
                interpolate(step, rgb);
            }
        }
        return new LinearImage(width(), height(), rgb);
    }

    /** Gives pixels without samples the mean of those beside or above and below them, at some distance. */
    private void interpolate(int step, float[] rgb) {
        IntStream.rangeClosed(0, (height() - 1) / (2 * step)).parallel().forEach(pair -> {
            int row = 2 * step * pair;
            for (int column = step; column < width(); column += 2 * step) {
                int left = pixel(column - step, row);
                setMean(pixel(column, row), left, column + step < width() ? left + 2 * step : left, rgb);
            }
        });
        IntStream.range(0, (height() - 1 + step) / (2 * step)).parallel().forEach(pair -> {
            int row = 2 * step * pair + step;
            for (int column = 0; column < width(); column += step) {
                int above = pixel(column, row - step);
                setMean(pixel(column, row), above, row + step < height() ? above + 2 * step * width() : above, rgb);
            }
        });
    }

    private void setMean(int pixel, int first, int second, float[] rgb) {
        if (samples[pixel] == 0) {
            for (int channel = 0; channel < 3; channel++) {
                rgb[3 * pixel + channel] = (rgb[3 * first + channel] + rgb[3 * second + channel]) / 2;
            }
        }
    }

    private void put(int pixel, float[] rgb) {
        int count = samples(pixel);
        // most pictures of a window have one sample, which needs no division
        double scale = count == 1 ? exposure() : exposure() / count;
        for (int channel = 3 * pixel; channel < 3 * pixel + 3; channel++) {
            // light is finite, but exposure() may lift it above what a picture can hold
            rgb[channel] = (float) Math.min(Float.MAX_VALUE, sums[channel] * scale);
        }
    }
}
