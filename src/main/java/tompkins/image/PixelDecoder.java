package tompkins.image;

import java.awt.color.ColorSpace;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;

/**
 * The pixels of a raster as red, green, blue and opacity. Whole numbers are divided by the largest that their bits can
 * hold, and nothing else is done to them: Java's own conversion would change the brightness of grey pictures.
 */
final class PixelDecoder {

    private final Raster raster;
    private final ColorModel colours;
    private final int bands;
    private final float[] largest;

    private PixelDecoder(Raster raster, ColorModel colours) {
        this.raster = raster;
        this.colours = colours;
        this.bands = raster.getNumBands();
        this.largest = largest(raster.getSampleModel());
    }

    /**
     * Four numbers a pixel, colours not multiplied by the opacity.
     *
     * @throws FileException if the kind of colours or numbers is not one that can be read
     */
    static float[] rgba(Raster raster, ColorModel colours, String name) throws FileException {
        requireReadable(raster, colours, name);
        PixelDecoder decoder = new PixelDecoder(raster, colours);
        return colours instanceof IndexColorModel palette ? decoder.fromPalette(palette) : decoder.fromChannels();
    }

    private static void requireReadable(Raster raster, ColorModel colours, String name) throws FileException {
        int space = colours.getColorSpace().getType();
        if (space != ColorSpace.TYPE_RGB && space != ColorSpace.TYPE_GRAY || raster.getNumBands() > 4) {
            throw new FileException(name + ": its colours are neither grey nor red, green and blue; save it as RGB");
        }
        if (raster.getTransferType() == DataBuffer.TYPE_SHORT
                || raster.getTransferType() == DataBuffer.TYPE_INT
                        && raster.getSampleModel().getSampleSize(0) > 16) {
            throw new FileException(
                    name + ": its numbers are signed or 32-bit integers; allowed are 8 or 16 bits or floating point");
        }
    }

    private static float[] largest(SampleModel samples) {
        float[] largest = new float[samples.getNumBands()];
        boolean floating =
                samples.getDataType() == DataBuffer.TYPE_FLOAT || samples.getDataType() == DataBuffer.TYPE_DOUBLE;
        for (int band = 0; band < largest.length; band++) {
            largest[band] = floating ? 1 : (1 << samples.getSampleSize(band)) - 1;
        }
        return largest;
    }

    private float[] fromPalette(IndexColorModel palette) {
        int width = raster.getWidth();
        float[] rgba = new float[4 * width * raster.getHeight()];
        int[] row = new int[width * bands];
        int to = 0;
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(raster.getMinX(), raster.getMinY() + y, width, 1, row);
            for (int x = 0; x < width; x++) {
                int index = row[x * bands];
                if (index >= palette.getMapSize()) {
                    throw new IllegalArgumentException("a pixel's colour is not in the palette");
                }
                rgba[to++] = palette.getRed(index) / 255f;
                rgba[to++] = palette.getGreen(index) / 255f;
                rgba[to++] = palette.getBlue(index) / 255f;
                rgba[to++] = palette.getAlpha(index) / 255f;
            }
        }
        return rgba;
    }

    private float[] fromChannels() {
        int width = raster.getWidth();
        float[] rgba = new float[4 * width * raster.getHeight()];
        float[] row = new float[width * bands];
        int to = 0;
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(raster.getMinX(), raster.getMinY() + y, width, 1, row);
            for (int from = 0; from < row.length; from += bands) {
                putPixel(row, from, rgba, to);
                to += 4;
            }
        }
        return rgba;
    }

    private void putPixel(float[] row, int from, float[] rgba, int to) {
        int colourBands = bands < 3 ? 1 : 3;
        float opacity = bands > colourBands ? row[from + colourBands] / largest[colourBands] : 1;
        float multiplied = colours.isAlphaPremultiplied() && opacity > 0 ? opacity : 1;
        for (int channel = 0; channel < 3; channel++) {
            int band = colourBands == 1 ? 0 : channel;
            rgba[to + channel] = row[from + band] / largest[band] / multiplied;
        }
        rgba[to + 3] = opacity;
    }
}
