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

    Film(int width, int height) {
        this.width = width;
        this.height = height;
        sums = new float[Math.multiplyExact(3, width * height)];
        samples = new int[width * height];
    }

    void add(int column, int row, Colour colour) {
        int pixel = row * width + column;
        sums[3 * pixel] += (float) colour.red();
        sums[3 * pixel + 1] += (float) colour.green();
        sums[3 * pixel + 2] += (float) colour.blue();
        samples[pixel]++;
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
