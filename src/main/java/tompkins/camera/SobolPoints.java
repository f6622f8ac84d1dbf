package tompkins.camera;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Points of a five-dimensional Sobol sequence with Owen's scrambling. The sequence itself comes from a table, as 32-bit
 * fractions; each use scrambles it by its own hash, which keeps the first 2^n points evenly spread for every n.
 */
final class SobolPoints {

    static final int DIMENSIONS = 5;
    private static final double TWO_TO_32 = 0x1p32;

    /**
     * For each dimension and each byte of a point's number, what each value of the byte adds to the fraction, with the
     * bits reversed: scrambling works from the highest bit downwards, its hash from the lowest upwards.
     */
    private static final int[][][] REVERSED_FRACTIONS = fractionsOfBytes();

    private SobolPoints() {}

    private static int[][][] fractionsOfBytes() {
        List<int[]> directions = directions();
        int[][][] table = new int[DIMENSIONS][Integer.BYTES][256];
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            for (int bit = 0; bit < Integer.SIZE; bit++) {
                int[] ofByte = table[dimension][bit / 8];
                int first = 1 << (bit % 8);
                // a value is its highest bit and the rest, which is known by then
                for (int rest = 0; rest < first; rest++) {
                    ofByte[first + rest] =
                            ofByte[rest] ^ Integer.reverse(directions.get(bit)[dimension]);
                }
            }
        }
        return table;
    }

    /** For each bit of a point's number what it adds to the fractions, in each dimension. */
    private static List<int[]> directions() {
        InputStream file = SobolPoints.class.getResourceAsStream("sobol-directions.txt");
        try (BufferedReader table = new BufferedReader(new InputStreamReader(file, StandardCharsets.US_ASCII))) {
            return table.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> Stream.of(line.split(" "))
                            .mapToInt(number -> Integer.parseUnsignedInt(number, 16))
                            .toArray())
                    .toList();
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /**
     * The numbers of the points that stand at a place of the sequence, shuffled among each power of two of places.
     *
     * @param seeds says how they are shuffled; a number for each
     * @param points gets the numbers
     */
    static void shuffle(int place, int[] seeds, int[] points, int count) {
        Arrays.fill(points, 0, count, Integer.reverse(place));
        scramble(points, seeds, count);
        reverse(points, count);
    }

    /**
     * One coordinate of each of some points, scrambled, as fractions of 32 bits.
     *
     * @param points their numbers
     * @param seeds says how they are scrambled; a number for each
     * @param fractions gets the coordinates
     */
    static void fractions(int dimension, int[] points, int[] seeds, int[] fractions, int count) {
        int[][] table = REVERSED_FRACTIONS[dimension];
        for (int i = 0; i < count; i++) {
            int point = points[i];
            fractions[i] = table[0][point & 0xff]
                    ^ table[1][point >>> 8 & 0xff]
                    ^ table[2][point >>> 16 & 0xff]
                    ^ table[3][point >>> 24];
        }
        scramble(fractions, seeds, count);
        reverse(fractions, count);
    }

    /** A fraction of 32 bits as a number from 0 to below 1. */
    static double number(int fraction) {
        return (fraction & 0xffffffffL) / TWO_TO_32;
    }

    /** A hash in which each bit changes only higher bits: on reversed fractions, a nested permutation. */
    private static void scramble(int[] values, int[] seeds, int count) {
        for (int i = 0; i < count; i++) {
            int mixed = values[i] + seeds[i];
            mixed ^= mixed * 0x6c50b47c;
            mixed ^= mixed * 0xb82f1e52;
            mixed ^= mixed * 0xc7afe638;
            mixed ^= mixed * 0x8d22f6e6;
            values[i] = mixed;
        }
    }

    /** Reverses the bits, by shifts, which the compiler makes for several numbers at once. */
    private static void reverse(int[] values, int count) {
        for (int i = 0; i < count; i++) {
            int bits = values[i];
            bits = bits >>> 1 & 0x55555555 | (bits & 0x55555555) << 1;
            bits = bits >>> 2 & 0x33333333 | (bits & 0x33333333) << 2;
            values[i] = bits;
        }
        for (int i = 0; i < count; i++) {
            int bits = values[i];
            bits = bits >>> 4 & 0x0f0f0f0f | (bits & 0x0f0f0f0f) << 4;
            bits = bits >>> 8 & 0x00ff00ff | (bits & 0x00ff00ff) << 8;
            values[i] = bits >>> 16 | bits << 16;
        }
    }
}
