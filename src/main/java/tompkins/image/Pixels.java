package tompkins.image;

/**
 * The pixels of a picture file in linear light, row after row.
 *
 * @param width pixels in a row
 * @param height number of rows
 * @param rgba red, green, blue and opacity of each pixel; the colours are not multiplied by the opacity
 */
record Pixels(int width, int height, float[] rgba) {

    /**
     * Checks the size that a header claims, before anything of that size is made.
     *
     * @throws FileException if it has no pixels, or too many
     */
    static void requireSize(long width, long height, String name) throws FileException {
        if (width < 1 || height < 1 || width > PictureFile.MOST_PIXELS || width * height > PictureFile.MOST_PIXELS) {
            throw new FileException(name + ": claims to have " + width + " x " + height
                    + " pixels; a picture may have from 1 to " + PictureFile.MOST_PIXELS);
        }
    }
}
