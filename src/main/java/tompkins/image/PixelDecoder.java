package tompkins.image;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;

/**
 * The pixels of an image of whole numbers as red, green, blue and opacity. The numbers are divided by the largest that
 * their bits can hold, and nothing else is done to them: Java's own conversion would change the brightness of grey
 * pictures.
 */
final class PixelDecoder {

    private final Raster raster;
    private final int bands;
    private final float[] largest;

    private PixelDecoder(BufferedImage image) {
        this.raster = image.getRaster();
        this.bands = raster.getNumBands();
        this.largest = largest(raster.getSampleModel());
    }

    /** The pixels of an image whose colours are not multiplied by the opacity. */
    static Pixels decode(BufferedImage image) {
        PixelDecoder decoder = new PixelDecoder(image);
        float[] rgba = image.getColorModel() instanceof IndexColorModel palette
                ? decoder.fromPalette(palette)
                : decoder.fromChannels();
        return new Pixels(image.getWidth(), image.getHeight(), rgba);
    }

    private static float[] largest(SampleModel samples) {
        float[] largest = new float[samples.getNumBands()];
        for (int band = 0; band < largest.length; band++) {
            largest[band] = (1 << samples.getSampleSize(band)) - 1;
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
        for (int channel = 0; channel < 3; channel++) {
            int band = colourBands == 1 ? 0 : channel;
            rgba[to + channel] = row[from + band] / largest[band];
        }
        rgba[to + 3] = opacity;
    }
}
