package tompkins.camera;

import org.hipparchus.random.SobolSequenceGenerator;

/**
 * Points of a four-dimensional Sobol sequence with Owen's scrambling. The sequence itself comes from a library, as 32-bit
 * fractions; each use scrambles it by its own hash, which keeps every power of two of points evenly spread.
 */
final class SobolPoints {

    private static final int DIMENSIONS = 4;
    private static final double TWO_TO_32 = 0x1p32;

    /** The direction numbers: the points with the numbers 1, 2, 4, 8, ... as fractions of 2^32. */
    private static final int[][] DIRECTIONS = directions();

    private SobolPoints() {}

    private static int[][] directions() {
        SobolSequenceGenerator sequence = new SobolSequenceGenerator(DIMENSIONS);
        int[][] directions = new int[DIMENSIONS][32];
        int[] before = new int[DIMENSIONS];
        for (int bit = 0; bit < 31; bit++) {
            // the library runs in Gray code: its points 2^bit - 1 and 2^bit differ by one direction number
            before = bit == 0 ? before : fractions(sequence.skipTo((1 << bit) - 1));
            int[] after = fractions(sequence.skipTo(1 << bit));
            for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
                directions[dimension][bit] = before[dimension] ^ after[dimension];
            }
        }
        return directions;
    }

    private static int[] fractions(double[] point) {
        int[] fractions = new int[DIMENSIONS];
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            fractions[dimension] = (int) (long) (point[dimension] * TWO_TO_32);
        }
        return fractions;
    }

    /** The number of the point that stands at a place of the sequence, shuffled among each power of two of places. */
    static int shuffled(int place, int seed) {
        return Integer.reverse(scramble(Integer.reverse(place), seed));
    }

    /** One coordinate of a point, scrambled, from 0 to below 1. */
    static double coordinate(int number, int dimension, int seed) {
        int fraction = 0;
        int[] directions = DIRECTIONS[dimension];
        for (int rest = number, bit = 0; rest != 0; rest >>>= 1, bit++) {
            if ((rest & 1) != 0) {
                fraction ^= directions[bit];
            }
        }
        // scrambling works from the highest bit downwards, the hash from the lowest upwards
        int scrambled = Integer.reverse(scramble(Integer.reverse(fraction), seed));
        return (scrambled & 0xffffffffL) / TWO_TO_32;
    }

    /** A hash in which each bit changes only higher bits: on reversed fractions, a nested permutation. */
    private static int scramble(int value, int seed) {
        int mixed = value + seed;
        mixed ^= mixed * 0x6c50b47c;
        mixed ^= mixed * 0xb82f1e52;
        mixed ^= mixed * 0xc7afe638;
        mixed ^= mixed * 0x8d22f6e6;
        return mixed;
    }
}
