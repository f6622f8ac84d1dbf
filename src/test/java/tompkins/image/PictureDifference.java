package tompkins.image;

import java.awt.image.BufferedImage;

/** Root mean square differences between two pictures of the same size. */
public final class PictureDifference {

    private PictureDifference() {}

    /** That of the levels from 0 to 255, over all channels. */
    public static double ofLevels(BufferedImage first, BufferedImage second) {
        double sum = squares(first, second, 0) + squares(first, second, 8) + squares(first, second, 16);
        return Math.sqrt(sum / (3.0 * first.getWidth() * first.getHeight()));
    }

    /**
     * That of the levels of one channel.
     *
     * @param shift the lowest bit of the channel: 16 for red, 8 for green, 0 for blue
     */
    static double ofLevels(BufferedImage first, BufferedImage second, int shift) {
        return Math.sqrt(squares(first, second, shift) / ((double) first.getWidth() * first.getHeight()));
    }

    private static double squares(BufferedImage first, BufferedImage second, int shift) {
        double sum = 0;
        for (int row = 0; row < first.getHeight(); row++) {
            for (int column = 0; column < first.getWidth(); column++) {
                int a = first.getRGB(column, row);
                int b = second.getRGB(column, row);
                sum += Math.pow((a >> shift & 0xff) - (b >> shift & 0xff), 2);
            }
        }
        return sum;
    }

    /** That in linear light, over all channels. */
    public static double ofLight(LinearImage first, LinearImage second) {
        double sum = 0;
        for (int i = 0; i < first.rgb().length; i++) {
            double difference = first.rgb()[i] - second.rgb()[i];
            sum += difference * difference;
        }
        return Math.sqrt(sum / first.rgb().length);
    }
}
