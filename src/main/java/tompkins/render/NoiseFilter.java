package tompkins.render;

import java.util.Arrays;
import java.util.stream.IntStream;
import tompkins.image.LinearImage;

/**
 * Shows a blurred picture that has few samples without most of its noise. Each pixel becomes a mean of those around it,
 * in which others count as far as the squares of three by three pixels around both differ by no more than their samples
 * do by chance: non-local means, A. Buades, B. Coll and J.-M. Morel 2005, with variances as F. Rousselle, C. Knaus and
 * M. Zwicker 2012 take them. What differs more, such as the edges of what is sharp, stays. A coarse picture is filtered
 * before the rest of its pixels is interpolated. In Fig. 3(a) the error of one sample falls from 0.18 to 0.05, that of
 * four from 0.061 to 0.02, which takes 18 without the filter.
 */
final class NoiseFilter {

    /** How far away other pixels are that count. */
    private static final int REACH = 2;

    /** Few samples tell little of their variance: it is the mean of what those of pixels tell that are so near. */
    private static final int VARIANCE_REACH = 3;

    private static final int BORDER = 2 * REACH + VARIANCE_REACH + 1;

    /** Rows that are filtered together. */
    private static final int BAND = 16;

    /** Pixels of the squares that are compared. */
    private static final int SQUARE = 9;

    /** Squared differences of nine pixels and three channels that nobody sees, where samples happen to be equal. */
    private static final float INVISIBLE = 3e-4f;

    /** More light and more variance become this: sums of all that a pixel is compared with stay finite. */
    private static final float BRIGHTEST = 1e36f;

    private final Film film;
    private final int stride;
    private final int width;
    private final int height;

    /** The width of the planes: the picture with a border, in which its edge is continued. */
    private final int down;

    /** The channels. */
    private final float[][] light = new float[3][];

    /** The variances of the means of the square around each pixel, added up. */
    private final float[] variances;

    private NoiseFilter(Film film, int stride, float[] rgb) {
        this.film = film;
        this.stride = stride;
        width = (film.width() - 1) / stride + 1;
        height = (film.height() - 1) / stride + 1;
        down = width + 2 * BORDER;
        float[] variance = new float[down * (height + 2 * BORDER)];
        variances = new float[variance.length];
        Arrays.setAll(light, channel -> new float[variance.length]);
        IntStream.range(-BORDER, height + BORDER).parallel().forEach(row -> read(row, rgb, variance));
        if (film.samples(0) == 1) {
            IntStream.range(1 - BORDER, height + BORDER).parallel().forEach(row -> compare(row, variance));
        }
        int reach = 2 * REACH;
        IntStream.range(-reach, height + reach).parallel().forEach(row -> addUp(row, variance));
    }

    /**
     * The picture on a film whose pixels all have one sample, or two or more; there may be none between coarse ones.
     */
    static LinearImage image(Film film) {
        int stride = film.completeStride();
        float[] rgb = film.means();
        NoiseFilter filter = new NoiseFilter(film, stride, rgb);
        int bands = (filter.height + BAND - 1) / BAND;
        IntStream.range(0, bands).parallel().forEach(band -> filter.filter(BAND * band, rgb));
        return film.interpolated(stride, rgb);
    }

    private static int inside(int place, int size) {
        return Math.min(Math.max(place, 0), size - 1);
    }

    private int place(int column, int row) {
        return (row + BORDER) * down + column + BORDER;
    }

    private int pixel(int column, int row) {
        return film.pixel(stride * inside(column, width), stride * inside(row, height));
    }

    private void read(int row, float[] rgb, float[] variance) {
        int lastSamples = 0;
        double growth = 1;
        for (int column = -BORDER; column < width + BORDER; column++) {
            int pixel = pixel(column, row);
            int place = place(column, row);
            int samples = film.samples(pixel);
            if (samples > 1) {
                growth = samples == lastSamples ? growth : Math.pow(samples, PixelVariance.POWER);
                lastSamples = samples;
                variance[place] = (float) Math.min(BRIGHTEST, film.sampleVariance(pixel) / growth);
            }
            for (int channel = 0; channel < 3; channel++) {
                light[channel][place] = Math.min(BRIGHTEST, rgb[3 * pixel + channel]);
            }
        }
    }

    /** Single samples vary as much as they differ from those on the left and above. */
    private void compare(int row, float[] variance) {
        float[][] differences = new float[2][down - 1];
        int first = place(1 - BORDER, row);
        differ(first, -1, differences[0]);
        differ(first, -down, differences[1]);
        for (int i = 0; i < down - 1; i++) {
            variance[first + i] = Math.min(BRIGHTEST, (differences[0][i] + differences[1][i]) / 12);
        }
    }

    /** The variances of the squares around the pixels of a row. */
    private void addUp(int row, float[] variance) {
        float[] columns = new float[down];
        for (int line = row - VARIANCE_REACH; line <= row + VARIANCE_REACH; line++) {
            int first = place(-BORDER, line);
            for (int i = 0; i < down; i++) {
                columns[i] += variance[first + i];
            }
        }
        int side = 2 * VARIANCE_REACH + 1;
        float share = (float) SQUARE / (side * side);
        int first = place(-BORDER, row);
        for (int i = VARIANCE_REACH; i < down - VARIANCE_REACH; i++) {
            float sum = 0;
            for (int j = i - VARIANCE_REACH; j <= i + VARIANCE_REACH; j++) {
                sum += columns[j];
            }
            variances[first + i] = share * sum;
        }
    }

    /**
     * Filters some rows, which share the differences of their squares. What a pixel counts for another one is what that
     * counts for it.
     */
    private void filter(int top, float[] rgb) {
        int end = Math.min(top + BAND, height);
        float[][] differences = new float[3][width + 2 * REACH + 2];
        float[] weights = new float[width + 2 * REACH];
        float[][] sums = new float[4 * (end - top)][width];
        for (int row = top; row < end; row++) {
            for (int channel = 0; channel < 3; channel++) {
                System.arraycopy(light[channel], place(0, row), sums[4 * (row - top) + channel], 0, width);
            }
            Arrays.fill(sums[4 * (row - top) + 3], 1);
        }
        for (int y = 0; y <= REACH; y++) {
            for (int x = y == 0 ? 1 : -REACH; x <= REACH; x++) {
                int offset = y * down + x;
                for (int row = top - y - 2; row < end; row++) {
                    differ(place(-REACH - 1, row + 1), offset, differences[Math.floorMod(row, 3)]);
                    if (row >= top - y) {
                        weigh(place(-REACH, row), offset, differences, weights);
                    }
                    if (row >= top) {
                        add(weights, REACH, place(0, row) + offset, sums, row - top);
                    }
                    if (row >= top - y && row + y < end) {
                        add(weights, REACH - x, place(-x, row), sums, row + y - top);
                    }
                }
            }
        }
        for (int row = top; row < end; row++) {
            float[] all = sums[4 * (row - top) + 3];
            for (int column = 0; column < width; column++) {
                for (int channel = 0; channel < 3; channel++) {
                    rgb[3 * pixel(column, row) + channel] = sums[4 * (row - top) + channel][column] / all[column];
                }
            }
        }
    }

    /** How much the pixels of a line differ from those at an offset: the squares, added up. */
    private void differ(int first, int offset, float[] differences) {
        float[] red = light[0];
        float[] green = light[1];
        float[] blue = light[2];
        for (int i = 0; i < differences.length; i++) {
            int here = first + i;
            float r = red[here] - red[here + offset];
            float g = green[here] - green[here + offset];
            float b = blue[here] - blue[here + offset];
            differences[i] = r * r + g * g + b * b;
        }
    }

    /** What pixels at an offset count: 1 if they differ as by chance, or less. */
    private void weigh(int first, int offset, float[][] differences, float[] weights) {
        float[] above = differences[0];
        float[] here = differences[1];
        float[] below = differences[2];
        for (int i = 0; i < weights.length; i++) {
            float sum = above[i]
                    + above[i + 1]
                    + above[i + 2]
                    + here[i]
                    + here[i + 1]
                    + here[i + 2]
                    + below[i]
                    + below[i + 1]
                    + below[i + 2];
            float chance = 3 * (variances[first + i] + variances[first + i + offset]);
            float known = chance + INVISIBLE;
            float ratio = known / (known + Math.max(0, sum - chance) / 4);
            weights[i] = ratio * ratio * ratio * ratio;
        }
    }

    /** Adds the light of a line, and its weights, to the sums of a row. */
    private void add(float[] weights, int firstWeight, int first, float[][] sums, int row) {
        for (int channel = 0; channel < 3; channel++) {
            float[] values = light[channel];
            float[] sum = sums[4 * row + channel];
            for (int i = 0; i < width; i++) {
                sum[i] += weights[firstWeight + i] * values[first + i];
            }
        }
        float[] sum = sums[4 * row + 3];
        for (int i = 0; i < width; i++) {
            sum[i] += weights[firstWeight + i];
        }
    }
}
