package tompkins.studio;

import tompkins.image.ToneCurve;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;

/** Size and quality of the picture. */
@Meaning("Size and quality of the picture")
public record RenderSettings(
        @Meaning(value = "Pixels in a row", unit = "pixels") int width,
        @Meaning(value = "Number of rows", unit = "pixels") int height,

        @Meaning("Samples per pixel, 1 to 1048576; 1 is taken in the centre of the pixel and of the lens")
        int samples,

        @Meaning(
                value =
                        "The root mean square error, in linear light where white is 1, until which samples are taken where"
                                + " they are needed (at most 65536 per pixel), 0.000001 to 1; 0 for the same number of samples everywhere")
        double targetError,

        @Meaning("Seed for the positions of the samples; the same seed gives the same picture")
        long seed,

        @Meaning("How many surfaces may send a ray on, 0 to 1000000, before the ray is given up")
        int maximumDepth,

        @Meaning(
                "How light becomes numbers in a file of whole numbers: linear writes it as it is, as the paper does, which screens show too dark;"
                        + " srgb writes it as screens expect it")
        ToneCurve toneCurve) {

    /**
     * 640 x 480 with one sample per pixel: the cheapest picture, and the best with one sample, because it is taken in
     * the centre (see the charts of antialiasing in docs/speed-and-accuracy.md).
     */
    public static final RenderSettings DEFAULT = new RenderSettings(640, 480, 1, 0, 1, 1000, ToneCurve.LINEAR);

    /** Largest number of pixels in a row or a column. */
    public static final int LONGEST_SIDE = 65_535;

    /** Largest number of pixels of a picture. */
    public static final long MOST_PIXELS = 100_000_000;

    /** Largest number of samples per pixel. */
    public static final int MOST_SAMPLES = 1 << 20;

    /** Smallest error that can be asked for: below it, rounding of the light itself matters. */
    public static final double SMALLEST_ERROR = 1e-6;

    /** Checks all values. */
    public RenderSettings {
        Require.within("width", width, 1, LONGEST_SIDE);
        Require.within("height", height, 1, LONGEST_SIDE);
        if ((long) width * height > MOST_PIXELS) {
            throw new InvalidPropertyException(
                    "height",
                    "small enough for at most " + MOST_PIXELS + " pixels",
                    height + " (with width " + width + ")");
        }
        Require.within("samples", samples, 1, MOST_SAMPLES);
        Require.zeroOrWithin("targetError", targetError, SMALLEST_ERROR, 1);
        Require.within("maximumDepth", maximumDepth, 0, 1_000_000);
    }

    /** Number of pixels of the picture. */
    public long pixels() {
        return (long) width * height;
    }

    /** The same settings with another size. */
    public RenderSettings withSize(int newWidth, int newHeight) {
        return new RenderSettings(newWidth, newHeight, samples, targetError, seed, maximumDepth, toneCurve);
    }

    /** The same settings with a number of samples that is the same for each pixel, and without a target error. */
    public RenderSettings withSamples(int newSamples) {
        return new RenderSettings(width, height, newSamples, 0, seed, maximumDepth, toneCurve);
    }

    /** The same settings with another target error; 0 for the same number of samples everywhere. */
    public RenderSettings withTargetError(double newTargetError) {
        return new RenderSettings(width, height, samples, newTargetError, seed, maximumDepth, toneCurve);
    }

    /** The same settings with another seed. */
    public RenderSettings withSeed(long newSeed) {
        return new RenderSettings(width, height, samples, targetError, newSeed, maximumDepth, toneCurve);
    }
}
