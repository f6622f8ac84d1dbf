package tompkins.image;

/**
 * A photograph in linear light: red, green and blue for each pixel, row 0 at the top. Values are not bounded; 1 is the
 * brightest that a screen shows. The array is handed over, not copied: nobody may change it afterwards.
 *
 * @param width pixels in a row
 * @param height number of rows
 * @param rgb three numbers a pixel, row after row from the top
 */
public record LinearImage(int width, int height, float[] rgb) {

    /**
     * Checks the size.
     *
     * @throws IllegalArgumentException if a side is below 1, if the pixels do not fit into one array, or if the number
     *     of values does not fit the size
     */
    public LinearImage {
        if (rgb.length != requireSize(width, height)) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height + " pixels needs "
                    + requireSize(width, height) + " values, there are " + rgb.length);
        }
    }

    /**
     * Number of values that a picture of this size needs: three for each pixel.
     *
     * @throws IllegalArgumentException if a side is below 1, or if the values do not fit into one array
     */
    public static int requireSize(int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException(
                    "width and height of a picture must be 1 or more, were " + width + " x " + height);
        }
        if (3L * width * height > Integer.MAX_VALUE) {
            throw new IllegalArgumentException(
                    "a picture must have at most " + Integer.MAX_VALUE / 3 + " pixels, was " + width + " x " + height);
        }
        return 3 * width * height;
    }

    /**
     * One value of one pixel.
     *
     * @param x column, from 0 at the left
     * @param y row, from 0 at the top
     * @param channel 0 red, 1 green, 2 blue
     * @throws IndexOutOfBoundsException if there is no such pixel or channel
     */
    public float value(int x, int y, int channel) {
        if (x < 0 || x >= width || y < 0 || y >= height || channel < 0 || channel > 2) {
            throw new IndexOutOfBoundsException("no channel " + channel + " of pixel (" + x + ", " + y
                    + ") in a picture of " + width + " x " + height + " pixels");
        }
        return rgb[3 * (y * width + x) + channel];
    }
}
