package tompkins.camera;

import java.util.Arrays;
import tompkins.ray.RayPacket;

/**
 * Places in the pixel, on the lens and in the exposure time for each sample of a pixel. They depend on the seed, the
 * pixel and the number of the sample alone, so that a picture does not depend on which thread took which sample. One
 * for each thread.
 *
 * <p>The places are the points of a five-dimensional Sobol sequence, scrambled differently in each pixel (Owen
 * scrambling by hashing: Laine and Karras 2011): the first 2^n samples fill pixel, lens and exposure time evenly for
 * every n. Among the samplers that were compared it needs the least time for the same error of a picture (see the
 * charts of the aperture in docs/speed-and-accuracy.md). It works through a block in short loops, from which the
 * compiler makes instructions for several pixels at once; this takes two thirds of the time of one pixel after the
 * other.
 */
public final class PixelSampler {

    /**
     * The number of the sample in the centre of the pixel and of the lens, in the middle of the exposure time: the one
     * that stands for all where one is enough.
     */
    public static final int CENTRE = -1;

    private final int seed;
    private final boolean wideAperture;
    private final boolean blursInTime;

    private final int[] pixels = new int[RayPacket.MOST];
    private final int[] points = new int[RayPacket.MOST];
    private final int[] seeds = new int[RayPacket.MOST];
    private final int[] fractions = new int[RayPacket.MOST];

    /**
     * A sampler for one picture.
     *
     * @param seed other seeds give other places
     * @param wideAperture whether the place on the lens matters; for a pinhole it stays in the centre
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

    /**
     * Chooses the places of one sample of each pixel.
     *
     * @param places the pixels, at most {@link RayPacket#MOST}; gets the places
     * @param sample {@link #CENTRE}, or the number of the sample from 0 upwards
     */
    public void choose(SamplePlaces places, int sample) {
        int count = places.count();
        Arrays.fill(places.lensX, 0, count, 0);
        Arrays.fill(places.lensY, 0, count, 0);
        Arrays.fill(places.moments, 0, count, SamplePlaces.MIDDLE);
        if (sample == CENTRE) {
            for (int i = 0; i < count; i++) {
                places.x[i] = places.columns[i] + 0.5;
                places.y[i] = places.rows[i] + 0.5;
            }
            return;
        }
        hashPixels(places, count);
        SobolPoints.shuffle(sample, pixels, points, count);
        // the first dimensions fill their square or cube best; they go to what blurs most
        if (wideAperture) {
            coordinates(0, places.lensX, count);
            coordinates(1, places.lensY, count);
            toLens(places, count);
        }
        if (!blursInTime) {
            coordinates(2, places.x, count);
            coordinates(3, places.y, count);
        } else if (wideAperture) {
            // among the last three, 2 and 4 combine worst, so that neither is the moment, which blurs more than the
            // pixel
            coordinates(3, places.moments, count);
            coordinates(2, places.x, count);
            coordinates(4, places.y, count);
        } else {
            coordinates(0, places.moments, count);
            coordinates(1, places.x, count);
            coordinates(2, places.y, count);
        }
        for (int i = 0; i < count; i++) {
            places.x[i] += places.columns[i];
            places.y[i] += places.rows[i];
        }
    }

    private void hashPixels(SamplePlaces places, int count) {
        System.arraycopy(places.rows, 0, pixels, 0, count);
        hash(pixels, count);
        for (int i = 0; i < count; i++) {
            pixels[i] += places.columns[i];
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

    private static void toLens(SamplePlaces places, int count) {
        for (int i = 0; i < count; i++) {
            double radius = ConcentricMap.radius(places.lensX[i], places.lensY[i]);
            double angle = ConcentricMap.angle(places.lensX[i], places.lensY[i]);
            places.lensX[i] = radius * Math.cos(angle);
            places.lensY[i] = radius * Math.sin(angle);
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
