package tompkins.image;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.util.Comparator;
import java.util.PriorityQueue;

/**
 * Pictures with at most 256 colours, for GIF, and for PNG files of half the size. The palette that the JDK chooses for
 * a GIF leaves bands in a sky, an error three times as large.
 */
public final class Palette {

    private static final int MOST = 256;
    private static final int CHANNELS = 3;

    private Palette() {}

    /**
     * A copy of an opaque picture with a palette. The pixels whose colours differ most are parted at their mean, again
     * and again; each part gets its mean colour. A picture with no more than 256 colours keeps them.
     */
    public static BufferedImage reduced(BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        long[] pixels = pixels(picture.getRGB(0, 0, width, height, null, 0, width));
        PriorityQueue<Part> parts = new PriorityQueue<>(Comparator.comparingDouble(part -> -part.error));
        parts.add(new Part(pixels, 0, pixels.length));
        while (parts.size() < MOST && parts.peek().error > 0) {
            Part worst = parts.remove();
            int middle = worst.split();
            parts.add(new Part(pixels, worst.from, middle));
            parts.add(new Part(pixels, middle, worst.to));
        }
        byte[] numbers = new byte[pixels.length];
        int[] palette = new int[parts.size()];
        int number = 0;
        for (Part part : parts) {
            palette[number] = part.colour();
            for (int i = part.from; i < part.to; i++) {
                numbers[(int) (pixels[i] >>> Integer.SIZE)] = (byte) number;
            }
            number++;
        }
        IndexColorModel model = new IndexColorModel(Byte.SIZE, number, palette, 0, false, -1, DataBuffer.TYPE_BYTE);
        BufferedImage result = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, model);
        System.arraycopy(
                numbers, 0, ((DataBufferByte) result.getRaster().getDataBuffer()).getData(), 0, numbers.length);
        return result;
    }

    /** Each pixel with its place in the picture above its colour. */
    private static long[] pixels(int[] colours) {
        long[] pixels = new long[colours.length];
        for (int place = 0; place < colours.length; place++) {
            pixels[place] = (long) place << Integer.SIZE | colours[place] & 0xFFFFFFL;
        }
        return pixels;
    }

    /** Pixels that get one colour, unless they are split. */
    private static final class Part {

        private final long[] pixels;
        private final int from;
        private final int to;
        private final double[] mean = new double[CHANNELS];

        /** The sum of the squares of what their channels differ from the mean. */
        private double error;

        /** The channel that contributes most to that. */
        private int widest;

        Part(long[] pixels, int from, int to) {
            this.pixels = pixels;
            this.from = from;
            this.to = to;
            double most = 0;
            for (int channel = 0; channel < CHANNELS; channel++) {
                long sum = 0;
                long squares = 0;
                for (int i = from; i < to; i++) {
                    int level = level(pixels[i], channel);
                    sum += level;
                    squares += level * level;
                }
                mean[channel] = (double) sum / (to - from);
                double own = squares - mean[channel] * sum;
                error += own;
                if (own > most) {
                    most = own;
                    widest = channel;
                }
            }
        }

        private static int level(long pixel, int channel) {
            return (int) (pixel >> Byte.SIZE * channel) & 0xFF;
        }

        /** Brings the pixels up to the mean of the widest channel to the front, and says where the others begin. */
        int split() {
            int low = from;
            int high = to;
            while (low < high) {
                if (level(pixels[low], widest) <= mean[widest]) {
                    low++;
                } else {
                    high--;
                    long pixel = pixels[low];
                    pixels[low] = pixels[high];
                    pixels[high] = pixel;
                }
            }
            return low;
        }

        int colour() {
            int colour = 0;
            for (int channel = 0; channel < CHANNELS; channel++) {
                colour |= (int) Math.round(mean[channel]) << Byte.SIZE * channel;
            }
            return colour;
        }
    }
}
