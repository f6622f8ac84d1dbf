package tompkins.study;

import java.util.SplittableRandom;
import tompkins.camera.ConcentricMap;

/**
 * Places in a pixel, on the lens and in the exposure time, and how much each counts. Like the program's own sampler, a
 * pattern depends on the seed and the pixel, never on earlier requests.
 */
abstract class SamplePattern {

    /** Place in the pixel, from 0 to 1. */
    double x = 0.5;

    /** Place in the pixel, from 0 to 1. */
    double y = 0.5;

    /** Place on the lens, in units of its radius. */
    double lensX;

    /** Place on the lens, in units of its radius. */
    double lensY;

    /** The part of the exposure time that has passed, from 0 to 1. */
    double moment = 0.5;

    /** Weight of the sample; the mean is the weighted one. */
    double weight = 1;

    private final long seed;

    SamplePattern(long seed) {
        this.seed = seed;
    }

    /** Goes to a pixel. */
    abstract void startPixel(int column, int row);

    /** Goes to a sample of the pixel. */
    abstract void goTo(int sample);

    /** A random generator for a pixel. */
    final SplittableRandom randomFor(int column, int row) {
        // the seed itself is not well mixed, but the first number of a generator is
        long mixed = new SplittableRandom(seed * 0x9e3779b97f4a7c15L + ((long) row << 32 | column)).nextLong();
        return new SplittableRandom(mixed);
    }

    /** Maps the unit square to the lens. */
    final void lens(double s, double t) {
        double radius = ConcentricMap.radius(s, t);
        double angle = ConcentricMap.angle(s, t);
        lensX = radius * Math.cos(angle);
        lensY = radius * Math.sin(angle);
    }

    /** The numbers from 0 to below {@code count} in random order. */
    static int[] shuffled(int count, SplittableRandom random) {
        int[] order = new int[count];
        for (int i = 0; i < count; i++) {
            int j = random.nextInt(i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }

    /** The sum without its whole part. */
    static double wrapped(double value, double shift) {
        double sum = value + shift;
        return sum - Math.floor(sum);
    }
}
