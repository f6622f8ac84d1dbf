package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.io.IOException;
import java.util.Arrays;

/** Turns luminance and chrominance (YCbCr) into red, green and blue (TIFF 6.0, sections 20 and 21). */
final class TiffLuminance {

    /** The share of red, green and blue in the luminance (ITU-R BT.601), if a file does not say. */
    private static final double[] USUAL_SHARES = {0.299, 0.587, 0.114};

    private final double red;
    private final double green;
    private final double blue;

    /** What is taken from the samples, as a share of the largest number, and by what they are multiplied then. */
    private final double[] black;

    private final double[] scale = new double[3];

    /**
     * Reads what the tags say of the samples.
     *
     * @throws FileException if no colours follow from it
     */
    TiffLuminance(TiffDirectory directory, TiffKind kind, String name) throws IOException {
        double largest = (1L << kind.bits()[0]) - 1;
        double half = 1L << kind.bits()[0] - 1;
        double[] shares = USUAL_SHARES;
        double[] range = {0, largest, half, largest, half, largest};
        if (!kind.isJpeg()) {
            shares = told(directory, TIFF.TAG_YCBCR_COEFFICIENTS, shares);
            range = told(directory, TIFF.TAG_REFERENCE_BLACK_WHITE, range);
        }
        boolean possible = Arrays.stream(shares).allMatch(share -> share > 0 && share < 1)
                && range[1] > range[0]
                && range[3] > range[2]
                && range[5] > range[4];
        if (!possible) {
            throw new FileException(name + ": no colours follow from its luminance with the shares "
                    + Arrays.toString(shares) + " and from black to white " + Arrays.toString(range)
                    + "; shares must lie between 0 and 1, and white must be above black");
        }
        red = shares[0];
        green = shares[1];
        blue = shares[2];
        black = new double[] {range[0] / largest, range[2] / largest, range[4] / largest};
        scale[0] = largest / (range[1] - range[0]);
        scale[1] = (half - 1) / (range[3] - range[2]);
        scale[2] = (half - 1) / (range[5] - range[4]);
    }

    private static double[] told(TiffDirectory directory, int tag, double[] usual) throws IOException {
        double[] numbers = directory.fractions(tag);
        return numbers.length == usual.length ? numbers : usual;
    }

    /** Replaces the samples of a pixel, from 0 to 1, by its colour. */
    void toColour(float[] rgba, int pixel) {
        double luminance = (rgba[pixel] - black[0]) * scale[0];
        double r = luminance + (2 - 2 * red) * (rgba[pixel + 2] - black[2]) * scale[2];
        double b = luminance + (2 - 2 * blue) * (rgba[pixel + 1] - black[1]) * scale[1];
        rgba[pixel] = possible(r);
        rgba[pixel + 1] = possible((luminance - red * r - blue * b) / green);
        rgba[pixel + 2] = possible(b);
    }

    private static float possible(double light) {
        return (float) Math.max(0, Math.min(1, light));
    }
}
