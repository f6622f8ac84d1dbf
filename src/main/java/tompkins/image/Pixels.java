package tompkins.image;

import tompkins.file.FileException;

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

    /**
     * Refuses floating point that is no number of light, and no opacity.
     *
     * @throws FileException if a value is infinite or not a number, or an opacity not from 0 to 1
     */
    void requireFinite(String name) throws FileException {
        for (int i = 0; i < rgba.length; i++) {
            boolean opacity = i % 4 == 3;
            if (!Float.isFinite(rgba[i]) || opacity && (rgba[i] < 0 || rgba[i] > 1)) {
                int pixel = i / 4;
                throw new FileException(name + ": pixel (" + pixel % width + ", " + pixel / width + ") has "
                        + (opacity ? "an opacity of " : "a value of ") + rgba[i] + "; "
                        + (opacity ? "opacities must be from 0 to 1" : "those of a picture must be finite"));
            }
        }
    }

    /** Makes dark what is bright, for files in which 0 is white; the opacity stays. */
    void invert() {
        for (int i = 0; i < rgba.length; i++) {
            rgba[i] = i % 4 == 3 ? rgba[i] : 1 - rgba[i];
        }
    }

    /** Undoes that the colours were multiplied by the opacity; where there is none, they stay. */
    void divideByOpacity() {
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            float opacity = rgba[pixel + 3];
            for (int channel = pixel; channel < pixel + 3 && opacity > 0; channel++) {
                rgba[channel] /= opacity;
            }
        }
    }
}
