package tompkins.image;

import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.io.IOException;

/**
 * Samples as red, green, blue and opacity. Whole numbers are divided by the largest that their bits can hold, and
 * nothing else is done to them: Java's own conversion would change the brightness of grey pictures.
 */
final class PixelDecoder {

    private static final int CHANNELS = 4;

    private PixelDecoder() {}

    /**
     * The pixels of samples.
     *
     * @param palette red, green, blue and opacity of each colour; null if the samples are grey or red, green and blue,
     *     with or without opacity
     * @throws IOException if a colour is not in the palette
     */
    static Pixels decode(Raster raster, float[] palette) throws IOException {
        int width = raster.getWidth();
        int bands = raster.getNumBands();
        float[] largest = largest(raster.getSampleModel());
        float[] rgba = new float[CHANNELS * width * raster.getHeight()];
        float[] row = new float[width * bands];
        for (int y = 0, to = 0; y < raster.getHeight(); y++) {
            raster.getPixels(raster.getMinX(), raster.getMinY() + y, width, 1, row);
            for (int from = 0; from < row.length; from += bands, to += CHANNELS) {
                if (palette == null) {
                    putPixel(row, from, largest, rgba, to);
                } else {
                    lookUp(palette, (int) row[from], rgba, to);
                }
            }
        }
        return new Pixels(width, raster.getHeight(), rgba);
    }

    private static float[] largest(SampleModel samples) {
        boolean floating = samples.getDataType() == DataBuffer.TYPE_FLOAT;
        float[] largest = new float[samples.getNumBands()];
        for (int band = 0; band < largest.length; band++) {
            largest[band] = floating ? 1 : (1 << samples.getSampleSize(band)) - 1;
        }
        return largest;
    }

    private static void putPixel(float[] row, int from, float[] largest, float[] rgba, int to) {
        int colours = largest.length < 3 ? 1 : 3;
        for (int channel = 0; channel < 3; channel++) {
            int band = colours == 1 ? 0 : channel;
            rgba[to + channel] = row[from + band] / largest[band];
        }
        rgba[to + 3] = largest.length > colours ? row[from + colours] / largest[colours] : 1;
    }

    private static void lookUp(float[] palette, int colour, float[] rgba, int to) throws IOException {
        if (colour >= palette.length / CHANNELS) {
            throw new IOException("a pixel's colour is not in the palette");
        }
        System.arraycopy(palette, CHANNELS * colour, rgba, to, CHANNELS);
    }
}
