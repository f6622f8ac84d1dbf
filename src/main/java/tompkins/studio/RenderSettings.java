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

        @Meaning("Samples for each pixel; 1 is taken in the centre of the pixel and of the lens")
        int samples,

        @Meaning("Seed of the places of the samples; the same seed gives the same picture")
        long seed,

        @Meaning("How many surfaces may send a ray on before it is given up")
        int maximumDepth,

        @Meaning("How light becomes numbers in a file of whole numbers")
        ToneCurve toneCurve) {

    /**
     * 640 x 480 with one sample for each pixel: the cheapest picture, and of all with one sample the best, because it is taken
     * in the centre (see the charts of antialiasing in docs/speed-and-accuracy.md).
     */
    public static final RenderSettings DEFAULT = new RenderSettings(640, 480, 1, 1, 1000, ToneCurve.LINEAR);

    /** Largest number of pixels in a row or a column. */
    public static final int LONGEST_SIDE = 65_535;

    /** Largest number of pixels of a picture. */
    public static final long MOST_PIXELS = 100_000_000;

    /** Largest number of samples for each pixel. */
    public static final int MOST_SAMPLES = 1 << 20;

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
        Require.within("maximumDepth", maximumDepth, 0, 1_000_000);
        Require.present("toneCurve", toneCurve);
    }

    /** The same settings with another size. */
    public RenderSettings withSize(int newWidth, int newHeight) {
        return new RenderSettings(newWidth, newHeight, samples, seed, maximumDepth, toneCurve);
    }

    /** The same settings with another number of samples. */
    public RenderSettings withSamples(int newSamples) {
        return new RenderSettings(width, height, newSamples, seed, maximumDepth, toneCurve);
    }

    /** The same settings with another seed. */
    public RenderSettings withSeed(long newSeed) {
        return new RenderSettings(width, height, samples, newSeed, maximumDepth, toneCurve);
    }

    /** The same settings with another recursion depth. */
    public RenderSettings withMaximumDepth(int newMaximumDepth) {
        return new RenderSettings(width, height, samples, seed, newMaximumDepth, toneCurve);
    }

    /** The same settings with another tone curve. */
    public RenderSettings withToneCurve(ToneCurve newToneCurve) {
        return new RenderSettings(width, height, samples, seed, maximumDepth, newToneCurve);
    }
}
