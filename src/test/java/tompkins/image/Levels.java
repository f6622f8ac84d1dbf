package tompkins.image;

import java.awt.image.BufferedImage;

/** Compares pictures by their levels from 0 to 255. */
public final class Levels {

    private Levels() {}

    /** The root mean square difference between the levels of two pictures of the same size, over all channels. */
    public static double difference(BufferedImage first, BufferedImage second) {
        double sum = 0;
        for (int row = 0; row < first.getHeight(); row++) {
            for (int column = 0; column < first.getWidth(); column++) {
                int a = first.getRGB(column, row);
                int b = second.getRGB(column, row);
                for (int shift = 0; shift <= 16; shift += 8) {
                    sum += Math.pow((a >> shift & 0xff) - (b >> shift & 0xff), 2);
                }
            }
        }
        return Math.sqrt(sum / (3.0 * first.getWidth() * first.getHeight()));
    }
}
