package tompkins.image;

import java.awt.Point;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferFloat;
import java.awt.image.DataBufferUShort;
import java.awt.image.PixelInterleavedSampleModel;
import java.awt.image.Raster;
import java.awt.image.SampleModel;
import java.awt.image.WritableRaster;
import java.util.stream.IntStream;

/** Photographs in the forms that screens and image writers take. */
public final class BufferedImages {

    private BufferedImages() {}

    /** The photograph for the screen: 8 bits per channel, type {@link BufferedImage#TYPE_INT_RGB}. */
    public static BufferedImage toBufferedImage(LinearImage image, ToneCurve curve) {
        LevelTable levels = LevelTable.of(curve);
        int width = image.width();
        BufferedImage result = new BufferedImage(width, image.height(), BufferedImage.TYPE_INT_RGB);
        WritableRaster raster = result.getRaster();
        float[] rgb = image.rgb();
        IntStream.range(0, image.height()).parallel().forEach(y -> {
            int[] row = new int[width];
            for (int x = 0, index = 3 * y * width; x < width; x++, index += 3) {
                row[x] = levels.levels(rgb[index], rgb[index + 1], rgb[index + 2]);
            }
            // Row by row, because an image whose data buffer was ever asked for stays slow to draw.
            raster.setDataElements(0, y, width, 1, row);
        });
        return result;
    }

    /** The photograph with 16 bits per channel. */
    static BufferedImage sixteenBit(LinearImage image, ToneCurve curve) {
        float[] rgb = image.rgb();
        short[] levels = new short[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            levels[i] = (short) curve.quantise(rgb[i], 65535);
        }
        return interleaved(image, DataBuffer.TYPE_USHORT, new DataBufferUShort(levels, levels.length));
    }

    /** The photograph's own values; the array is shared. */
    static BufferedImage floatingPoint(LinearImage image) {
        return interleaved(image, DataBuffer.TYPE_FLOAT, new DataBufferFloat(image.rgb(), image.rgb().length));
    }

    private static BufferedImage interleaved(LinearImage image, int dataType, DataBuffer buffer) {
        SampleModel samples = new PixelInterleavedSampleModel(
                dataType, image.width(), image.height(), 3, 3 * image.width(), new int[] {0, 1, 2});
        ColorModel colours = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, dataType);
        return new BufferedImage(colours, Raster.createWritableRaster(samples, buffer, new Point()), false, null);
    }
}
