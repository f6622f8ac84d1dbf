package tompkins.render;

/** The samples of pixels. Each pixel is written by one thread at a time, in the order of its samples. */
abstract sealed class PixelBuffer permits Film, PreviewFilm {

    private final int width;
    private final int height;
    private final double exposure;

    PixelBuffer(int width, int height, double exposure) {
        this.width = width;
        this.height = height;
        this.exposure = exposure;
    }

    final int width() {
        return width;
    }

    final int height() {
        return height;
    }

    /** Factor of all light in the picture. */
    final double exposure() {
        return exposure;
    }

    final int pixels() {
        return width * height;
    }

    /** The number of a pixel: row by row, from 0. */
    final int pixel(int column, int row) {
        return row * width + column;
    }

    /**
     * Adds the sum of one or more samples of a pixel.
     *
     * @param squared the sum of their squares, as of {@link Film#squared}
     */
    abstract void add(int pixel, double red, double green, double blue, double squared, int added);

    /** Number of samples of a pixel. */
    abstract int samples(int pixel);

    /** Number of pixels that have samples. */
    final int sampledPixels() {
        int sampled = 0;
        for (int pixel = 0; pixel < pixels(); pixel++) {
            sampled += samples(pixel) == 0 ? 0 : 1;
        }
        return sampled;
    }

    /** The smallest distance at which all pixels have samples; {@link Tile#SIZE} if there is none. */
    final int completeStride() {
        int stride = 1;
        while (stride < Tile.SIZE && !isComplete(stride)) {
            stride *= 2;
        }
        return stride;
    }

    private boolean isComplete(int stride) {
        for (int row = 0; row < height; row += stride) {
            for (int column = 0; column < width; column += stride) {
                if (samples(pixel(column, row)) == 0) {
                    return false;
                }
            }
        }
        return true;
    }
}
