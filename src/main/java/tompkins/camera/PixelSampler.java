package tompkins.camera;

import java.util.Arrays;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/**
 * Positions in the pixel, on the lens and in the exposure time for each sample of a pixel. They depend on the seed, the
 * pixel and the number of the sample alone, so that a picture does not depend on which thread took which sample. One
 * for each thread.
 *
 * <p>The positions are the points of a five-dimensional Sobol sequence, scrambled differently in each pixel (Owen
 * scrambling by hashing: Laine and Karras 2011): the first 2^n samples fill pixel, lens and exposure time evenly for
 * every n (see the charts of the aperture in docs/speed-and-accuracy.md). It works through a block in short loops, from
 * which the compiler makes instructions for several pixels at once.
 */
public final class PixelSampler extends Padded implements Sampler {

    /** The number of the sample in the centre of pixel and lens, in the middle of the exposure time. */
    public static final int CENTRE = -1;

    private final int seed;
    private final boolean wideAperture;
    private final boolean blursInTime;

    private final int[] pixels = new int[RayPacket.MOST];
    private final int[] points = new int[RayPacket.MOST];
    private final int[] fractions = new int[RayPacket.MOST];

    private final int[] seeds = new int[RayPacket.MOST];

    /**
     * A sampler for one picture.
     *
     * @param seed other seeds give other positions
     * @param wideAperture whether the position on the lens matters; for a pinhole it stays in the centre
     * @param blursInTime whether the moment matters; otherwise it stays in the middle of the exposure time
     */
    public PixelSampler(long seed, boolean wideAperture, boolean blursInTime) {
        int[] halves = {(int) (seed >>> 32)};
        hash(halves, 1);
        halves[0] ^= (int) seed;
        hash(halves, 1);
        this.seed = halves[0];
        this.wideAperture = wideAperture;
        this.blursInTime = blursInTime;
    }

    /** The number of a pixel's first sample, if it gets this many: a single one is taken in the centre. */
    public static int firstOf(int samples) {
        return samples == 1 ? CENTRE : 0;
    }

    @Override
    public void choose(SamplePositions positions, int sample) {
        int count = positions.count();
        Arrays.fill(positions.lensX, 0, count, 0);
        Arrays.fill(positions.lensY, 0, count, 0);
        Arrays.fill(positions.moments, 0, count, SamplePositions.MIDDLE);
        if (sample == CENTRE) {
            for (int i = 0; i < count; i++) {
                positions.x[i] = positions.columns[i] + 0.5;
                positions.y[i] = positions.rows[i] + 0.5;
            }
            return;
        }
        hashPixels(positions, count);
        SobolPoints.shuffle(sample, pixels, points, count);
        // the first dimensions fill their square or cube best; they go to what blurs most
        if (wideAperture) {
            coordinates(0, positions.lensX, count);
            coordinates(1, positions.lensY, count);
            toLens(positions, count);
        }
        if (!blursInTime) {
            coordinates(2, positions.x, count);
            coordinates(3, positions.y, count);
        } else if (wideAperture) {
            // of the last three, 2 and 4 combine worst, so that neither is the moment, which blurs more than the pixel
            coordinates(3, positions.moments, count);
            coordinates(2, positions.x, count);
            coordinates(4, positions.y, count);
        } else {
            coordinates(0, positions.moments, count);
            coordinates(1, positions.x, count);
            coordinates(2, positions.y, count);
        }
        for (int i = 0; i < count; i++) {
            positions.x[i] += positions.columns[i];
            positions.y[i] += positions.rows[i];
        }
    }

    private void hashPixels(SamplePositions positions, int count) {
        System.arraycopy(positions.rows, 0, pixels, 0, count);
        hash(pixels, count);
        for (int i = 0; i < count; i++) {
            pixels[i] += positions.columns[i];
        }
        hash(pixels, count);
        for (int i = 0; i < count; i++) {
            pixels[i] += seed;
        }
        hash(pixels, count);
    }

    private void coordinates(int dimension, double[] coordinates, int count) {
        for (int i = 0; i < count; i++) {
            seeds[i] = pixels[i] + dimension + 1;
        }
        hash(seeds, count);
        SobolPoints.fractions(dimension, points, seeds, fractions, count);
        for (int i = 0; i < count; i++) {
            coordinates[i] = SobolPoints.number(fractions[i]);
        }
    }

    private static void toLens(SamplePositions positions, int count) {
        for (int i = 0; i < count; i++) {
            double radius = ConcentricMap.radius(positions.lensX[i], positions.lensY[i]);
            double angle = ConcentricMap.angle(positions.lensX[i], positions.lensY[i]);
            positions.lensX[i] = radius * Math.cos(angle);
            positions.lensY[i] = radius * Math.sin(angle);
        }
    }

    /**
     * A mixing of 32 bits in which every bit of the input changes half of the output (lowbias32 of C. Wellons, 2018).
     */
    static void hash(int[] values, int count) {
        for (int i = 0; i < count; i++) {
            int mixed = values[i];
            mixed ^= mixed >>> 16;
            mixed *= 0x7feb352d;
            mixed ^= mixed >>> 15;
            mixed *= 0x846ca68b;
            mixed ^= mixed >>> 16;
            values[i] = mixed;
        }
    }
}
