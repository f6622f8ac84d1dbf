package tompkins.camera;

/**
 * Places in the pixel and on the lens for each sample of a pixel. They depend on the seed, the pixel and the number of the
 * sample alone, so that a picture does not depend on which thread took which sample. One for each thread.
 *
 * <p>The places are the points of a four-dimensional Sobol sequence, scrambled differently in each pixel (Owen scrambling by
 * hashing: Laine and Karras 2011): every power of two of first samples fills pixel and lens evenly.
 * Of the samplers that were compared it needs the least time for the same error of a picture (see the charts of the aperture
 * in docs/speed-and-accuracy.md).
 */
public final class PixelSampler {

    /** The number of the sample in the centre of the pixel and of the lens: the one that stands for all where one is enough. */
    public static final int CENTRE = -1;

    private final int seed;
    private final boolean wideLens;
    private double x;
    private double y;
    private double lensX;
    private double lensY;

    /**
     * A sampler for one picture.
     *
     * @param seed other seeds give other places
     * @param wideLens whether the place on the lens matters; for a pinhole it stays in the centre
     */
    public PixelSampler(long seed, boolean wideLens) {
        this.seed = hash((int) seed ^ hash((int) (seed >>> 32)));
        this.wideLens = wideLens;
    }

    /** The number of a pixel's first sample, if it gets this many: a single one is taken in the centre. */
    public static int firstOf(int samples) {
        return samples == 1 ? CENTRE : 0;
    }

    /** Goes to a sample of a pixel: {@link #CENTRE}, or a number from 0 upwards. */
    public void start(int column, int row, int sample) {
        if (sample == CENTRE) {
            x = column + 0.5;
            y = row + 0.5;
            lensX = 0;
            lensY = 0;
            return;
        }
        int pixel = hash(seed + hash(column + hash(row)));
        int place = SobolPoints.shuffled(sample, pixel);
        // the first two dimensions fill their square best; they go to the lens, over which more is blurred
        if (wideLens) {
            toLens(
                    SobolPoints.coordinate(place, 0, hash(pixel + 1)),
                    SobolPoints.coordinate(place, 1, hash(pixel + 2)));
        }
        x = column + SobolPoints.coordinate(place, 2, hash(pixel + 3));
        y = row + SobolPoints.coordinate(place, 3, hash(pixel + 4));
    }

    private void toLens(double s, double t) {
        double radius = ConcentricMap.radius(s, t);
        double angle = ConcentricMap.angle(s, t);
        lensX = radius * Math.cos(angle);
        lensY = radius * Math.sin(angle);
    }

    /** Place in the picture, in pixels. */
    public double x() {
        return x;
    }

    /** Place in the picture, in pixels. */
    public double y() {
        return y;
    }

    /** Place on the lens, in units of its radius. */
    public double lensX() {
        return lensX;
    }

    /** Place on the lens, in units of its radius. */
    public double lensY() {
        return lensY;
    }

    /** A mixing of 32 bits in which every bit of the input changes half of the output. */
    static int hash(int value) {
        int mixed = value;
        mixed ^= mixed >>> 16;
        mixed *= 0x7feb352d;
        mixed ^= mixed >>> 15;
        mixed *= 0x846ca68b;
        mixed ^= mixed >>> 16;
        return mixed;
    }
}
