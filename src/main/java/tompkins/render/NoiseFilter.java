package tompkins.render;

import java.util.Arrays;
import java.util.stream.IntStream;
import tompkins.image.LinearImage;

/**
 * Shows a blurred picture that has few samples without most of its noise. Each pixel becomes a mean of those around it,
 * in which others count as far as the squares of three by three pixels around both differ by no more than their samples
 * do by chance: non-local means, A. Buades, B. Coll and J.-M. Morel 2005, with variances as F. Rousselle, C. Knaus and
 * M. Zwicker 2012 take them. What differs more, such as the edges of what is sharp, stays. A coarse picture is filtered
 * before the rest of its pixels is interpolated.
 */
final class NoiseFilter {

    /** How far away other pixels are that count. */
    private static final int REACH = 2;

    /** Few samples tell little of their variance: it is the mean of what those of pixels tell that are so near. */
    private static final int VARIANCE_REACH = 3;

    /** Columns on both sides, in which the edge of the picture is continued. */
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

    /** The rows of each channel. */
    private final float[][][] light;

    /** The variances of the means of the square around each pixel, added up. */
    private final float[][] variances;

    private NoiseFilter(Film film, int stride, float[] rgb) {
        this.film = film;
        this.stride = stride;
        width = (film.width() - 1) / stride + 1;
        height = (film.height() - 1) / stride + 1;
        light = new float[3][height][width + 2 * BORDER];
        variances = new float[height][width + 2 * BORDER];
        float[][] variance = new float[height][width + 2 * BORDER];
        IntStream.range(0, height).parallel().forEach(row -> read(row, rgb, variance[row]));
        if (film.samples(0) == 1) {
            IntStream.range(0, height).parallel().forEach(row -> compare(row, variance[row]));
        }
        IntStream.range(0, height).parallel().forEach(row -> addUp(row, variance));
    }

    /**
     * The picture on a film whose pixels all have one sample, or two or more; there may be none between coarse ones.
     */
    static LinearImage image(Film film) {
        int stride = film.completeStride();
        float[] rgb = film.means();
        NoiseFilter filter = new NoiseFilter(film, stride, rgb);
        int bands = (filter.height + BAND - 1) / BAND;
        IntStream.range(0, bands).parallel().forEach(band -> filter.new Band(BAND * band).filter(rgb));
        return film.interpolated(stride, rgb);
    }

    private int pixel(int column, int row) {
        return film.pixel(stride * column, stride * row);
    }

    private void read(int row, float[] rgb, float[] variance) {
        int lastSamples = 0;
        double growth = 1;
        for (int column = 0; column < width; column++) {
            int pixel = pixel(column, row);
            int samples = film.samples(pixel);
            if (samples > 1) {
                growth = samples == lastSamples ? growth : Math.pow(samples, PixelVariance.POWER);
                lastSamples = samples;
                variance[BORDER + column] = (float) Math.min(BRIGHTEST, film.sampleVariance(pixel) / growth);
            }
            for (int channel = 0; channel < 3; channel++) {
                light[channel][row][BORDER + column] = Math.min(BRIGHTEST, rgb[3 * pixel + channel]);
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            continueEdges(light[channel][row]);
        }
        continueEdges(variance);
    }

    private void continueEdges(float[] line) {
        Arrays.fill(line, 0, BORDER, line[BORDER]);
        Arrays.fill(line, BORDER + width, line.length, line[BORDER + width - 1]);
    }

    /** A row; beyond the edge of the picture the one at the edge. */
    private float[] row(float[][] rows, int row) {
        return rows[Math.min(Math.max(row, 0), height - 1)];
    }

    /** Single samples vary as much as they differ from those on the left and above. */
    private void compare(int row, float[] variance) {
        float[][] others = new float[3][variance.length];
        float[][] differences = new float[2][variance.length];
        differ(row, -1, 0, others, differences[0]);
        differ(row, 0, -1, others, differences[1]);
        for (int i = 0; i < variance.length; i++) {
            variance[i] = Math.min(BRIGHTEST, (differences[0][i] + differences[1][i]) / 12);
        }
    }

    /** The variances of the squares around the pixels of a row. */
    private void addUp(int row, float[][] variance) {
        float[] columns = new float[width + 2 * BORDER];
        for (int line = row - VARIANCE_REACH; line <= row + VARIANCE_REACH; line++) {
            float[] values = row(variance, line);
            for (int i = 0; i < columns.length; i++) {
                columns[i] += values[i];
            }
        }
        int side = 2 * VARIANCE_REACH + 1;
        float fraction = (float) SQUARE / (side * side);
        for (int i = VARIANCE_REACH; i < columns.length - VARIANCE_REACH; i++) {
            float sum = 0;
            for (int j = i - VARIANCE_REACH; j <= i + VARIANCE_REACH; j++) {
                sum += columns[j];
            }
            variances[row][i] = fraction * sum;
        }
    }

    /** How much the pixels of a row differ from those at an offset: the squares, added up. */
    private void differ(int row, int x, int y, float[][] others, float[] differences) {
        copy(row + y, x, others);
        float[] red = row(light[0], row);
        float[] green = row(light[1], row);
        float[] blue = row(light[2], row);
        float[] otherRed = others[0];
        float[] otherGreen = others[1];
        float[] otherBlue = others[2];
        for (int i = 0; i < differences.length; i++) {
            float r = red[i] - otherRed[i];
            float g = green[i] - otherGreen[i];
            float b = blue[i] - otherBlue[i];
            differences[i] = r * r + g * g + b * b;
        }
    }

    /** The channels of a row, from a column further to the right. */
    private void copy(int row, int right, float[][] into) {
        for (int channel = 0; channel < 3; channel++) {
            copy(row(light[channel], row), right, into[channel]);
        }
    }

    private static void copy(float[] line, int right, float[] into) {
        System.arraycopy(line, Math.max(0, right), into, Math.max(0, -right), line.length - Math.abs(right));
    }

    /**
     * Some rows, which share the differences of their squares. What a pixel counts for another one is what that counts
     * for it. The loops have one index for all their arrays, for which rows are copied: the compiler turns them into
     * instructions for several pixels at once.
     */
    private final class Band {

        private final int top;
        private final int end;
        private final int length = width + 2 * BORDER;
        private final float[][] sums;
        private final float[][] differences = new float[3][length];
        private final float[] left = new float[length];
        private final float[] middle = new float[length];
        private final float[] right = new float[length];

        /** The channels of other pixels, and ones. */
        private final float[][] others = new float[4][length];

        private final float[] otherVariances = new float[length];
        private final float[] weights = new float[length];
        private final float[] otherWeights = new float[length];

        Band(int top) {
            this.top = top;
            end = Math.min(top + BAND, height);
            sums = new float[4 * (end - top)][];
            Arrays.fill(others[3], 1);
            for (int row = top; row < end; row++) {
                for (int channel = 0; channel < 3; channel++) {
                    sums[4 * (row - top) + channel] = light[channel][row].clone();
                }
                sums[4 * (row - top) + 3] = others[3].clone();
            }
        }

        void filter(float[] rgb) {
            for (int y = 0; y <= REACH; y++) {
                for (int x = y == 0 ? 1 : -REACH; x <= REACH; x++) {
                    for (int row = top - y - 2; row < end; row++) {
                        differ(row + 1, x, y, others, differences[Math.floorMod(row, 3)]);
                        if (row >= top - y) {
                            weigh(row, x, y);
                        }
                        if (row >= top) {
                            copy(row + y, x, others);
                            add(weights, row);
                        }
                        if (row >= top - y && row + y < end) {
                            copy(row, -x, others);
                            copy(weights, -x, otherWeights);
                            add(otherWeights, row + y);
                        }
                    }
                }
            }
            for (int row = top; row < end; row++) {
                write(row, rgb);
            }
        }

        /** What pixels at an offset count: 1 if they differ as by chance, or less. */
        private void weigh(int row, int x, int y) {
            float[] above = differences[0];
            float[] here = differences[1];
            float[] below = differences[2];
            for (int i = 0; i < length; i++) {
                middle[i] = above[i] + here[i] + below[i];
            }
            copy(middle, -1, left);
            copy(middle, 1, right);
            float[] ownVariances = row(variances, row);
            copy(row(variances, row + y), x, otherVariances);
            for (int i = 0; i < length; i++) {
                float chance = 3 * (ownVariances[i] + otherVariances[i]);
                float known = chance + INVISIBLE;
                float ratio = known / (known + Math.max(0, left[i] + middle[i] + right[i] - chance) / 4);
                weights[i] = ratio * ratio * ratio * ratio;
            }
        }

        /** Adds other light, and its weights, to the sums of a row. */
        private void add(float[] weights, int row) {
            for (int channel = 0; channel < 4; channel++) {
                float[] sum = sums[4 * (row - top) + channel];
                float[] values = others[channel];
                for (int i = 0; i < length; i++) {
                    sum[i] += weights[i] * values[i];
                }
            }
        }

        private void write(int row, float[] rgb) {
            int first = 4 * (row - top);
            for (int column = 0; column < width; column++) {
                int pixel = 3 * pixel(column, row);
                float fraction = 1 / sums[first + 3][BORDER + column];
                for (int channel = 0; channel < 3; channel++) {
                    rgb[pixel + channel] = fraction * sums[first + channel][BORDER + column];
                }
            }
        }
    }
}
