package tompkins.camera;

import org.hipparchus.random.SobolSequenceGenerator;

/**
 * Points of a four-dimensional Sobol sequence with Owen's scrambling. The sequence itself comes from a library, as 32-bit
 * fractions; each use scrambles it by its own hash, which keeps every power of two of points evenly spread.
 */
final class SobolPoints {

    private static final int DIMENSIONS = 4;
    private static final double TWO_TO_32 = 0x1p32;

    /** For each dimension and each byte of a point's number, what each value of the byte adds to the fraction. */
    private static final int[][][] FRACTIONS = fractionsOfBytes();

    private SobolPoints() {}

    private static int[][][] fractionsOfBytes() {
        int[][] directions = directions();
        int[][][] table = new int[DIMENSIONS][Integer.BYTES][256];
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            for (int bit = 0; bit < Integer.SIZE; bit++) {
                int[] ofByte = table[dimension][bit / 8];
                int first = 1 << (bit % 8);
                // a value is its highest bit and the rest, which is known by then
                for (int rest = 0; rest < first; rest++) {
                    ofByte[first + rest] = ofByte[rest] ^ directions[dimension][bit];
                }
            }
        }
        return table;
    }

    /** The direction numbers: the fractions that the bits of a point's number add up to (without carry). */
    private static int[][] directions() {
        SobolSequenceGenerator sequence = new SobolSequenceGenerator(DIMENSIONS);
        int[][] directions = new int[DIMENSIONS][Integer.SIZE];
        for (int bit = 0; bit < Integer.SIZE - 1; bit++) {
            // the library counts in Gray code, where the numbers 2^bit - 1 and 2^bit differ in one bit only
            int[] before = bit == 0 ? new int[DIMENSIONS] : fractions(sequence.skipTo((1 << bit) - 1));
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
        int[][] table = FRACTIONS[dimension];
        int fraction = table[0][number & 0xff]
                ^ table[1][number >>> 8 & 0xff]
                ^ table[2][number >>> 16 & 0xff]
                ^ table[3][number >>> 24];
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
