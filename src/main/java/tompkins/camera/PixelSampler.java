package tompkins.camera;

/**
 * Places in the pixel and on the lens for each sample of a pixel. They depend on the seed, the pixel and the number of the
 * sample alone, so that a picture does not depend on which thread took which sample. One for each thread.
 *
 * <p>The places are the points of a four-dimensional Sobol sequence, scrambled differently in each pixel (Owen scrambling by
 * hashing: Laine and Karras 2011): every power of two of first samples fills pixel and lens evenly.
 */
public final class PixelSampler {

    private static final int DIMENSIONS = 4;

    private final int seed;
    private final boolean centred;
    private double x;
    private double y;
    private double lensX;
    private double lensY;

    /**
     * A sampler for one picture.
     *
     * @param seed other seeds give other places
     * @param samples samples for each pixel; a single one is taken in the centre of the pixel and of the lens
     */
    public PixelSampler(long seed, int samples) {
        this.seed = hash((int) seed ^ hash((int) (seed >>> 32)));
        centred = samples == 1;
    }

    /** Goes to a sample of a pixel. */
    public void start(int column, int row, int sample) {
        if (centred) {
            x = column + 0.5;
            y = row + 0.5;
            lensX = 0;
            lensY = 0;
            return;
        }
        int pixel = hash(seed + hash(column + hash(row)));
        int place = SobolPoints.shuffled(sample, pixel);
        x = column + SobolPoints.coordinate(place, 0, hash(pixel + 1));
        y = row + SobolPoints.coordinate(place, 1, hash(pixel + 2));
        toDisc(
                SobolPoints.coordinate(place, 2, hash(pixel + 3)),
                SobolPoints.coordinate(place, 3, hash(pixel + DIMENSIONS)));
    }

    /** The concentric map (Shirley and Chiu 1997) of the unit square to the unit disc: even, and squares stay compact. */
    private void toDisc(double s, double t) {
        double a = 2 * s - 1;
        double b = 2 * t - 1;
        if (a == 0 && b == 0) {
            lensX = 0;
            lensY = 0;
            return;
        }
        boolean flat = Math.abs(a) > Math.abs(b);
        double radius = flat ? a : b;
        double angle = flat ? Math.PI / 4 * (b / a) : Math.PI / 2 - Math.PI / 4 * (a / b);
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
