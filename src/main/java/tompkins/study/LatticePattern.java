package tompkins.study;

import java.util.SplittableRandom;

/**
 * The points of references: a lattice rule in the order of van der Corput (generating vector of Cools, Kuo and Nuyens
 * 2006), shifted at random for each pixel. None of the methods that are compared uses it.
 */
final class LatticePattern extends SamplePattern {

    private static final long[] GENERATOR = {1, 182667, 469891, 498753, 110745};

    private final double[] shift = new double[GENERATOR.length];

    LatticePattern(long seed) {
        super(seed);
    }

    @Override
    void startPixel(int column, int row) {
        SplittableRandom random = randomFor(column, row);
        for (int i = 0; i < shift.length; i++) {
            shift[i] = random.nextDouble();
        }
    }

    @Override
    void goTo(int sample) {
        double place = (Integer.reverse(sample) & 0xffffffffL) * 0x1p-32;
        lens(wrapped(place * GENERATOR[0], shift[0]), wrapped(place * GENERATOR[1], shift[1]));
        x = wrapped(place * GENERATOR[2], shift[2]);
        y = wrapped(place * GENERATOR[3], shift[3]);
        moment = wrapped(place * GENERATOR[4], shift[4]);
    }
}
