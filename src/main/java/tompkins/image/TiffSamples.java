package tompkins.image;

import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * The samples in the rows of a TIFF strip: numbers of any bits, one after the other from the highest bit of the first
 * byte, or in the byte order of the file if they are whole pairs, threes or fours of bytes.
 */
final class TiffSamples {

    private static final int DIFFERENCES = 2;

    /** The largest number of the tag that is known. */
    static final int DIFFERENCES_OF_BYTES = 3;

    private final int[] bits;
    private final boolean floating;
    private final boolean littleEndian;
    private final long predictor;
    private final int columns;
    private final double[] largest;
    private final long[] codes;

    /**
     * For rows of {@code columns} pixels.
     *
     * @param bits of each sample of a pixel
     * @param predictor the number of the tag: whether samples are stored as differences
     */
    TiffSamples(int[] bits, boolean floating, ByteOrder order, long predictor, int columns) {
        this.bits = bits;
        this.floating = floating;
        this.littleEndian = order == ByteOrder.LITTLE_ENDIAN;
        this.predictor = predictor;
        this.columns = columns;
        this.codes = new long[columns * bits.length];
        this.largest = Arrays.stream(bits)
                .mapToDouble(each -> floating ? 1 : (1L << each) - 1)
                .toArray();
    }

    /** How many bytes such a row has. */
    long rowBytes() {
        return ((long) columns * Arrays.stream(bits).sum() + 7) / 8;
    }

    /** Reads a row that begins at a place. */
    void read(byte[] rows, int at) {
        if (predictor == DIFFERENCES_OF_BYTES && floating) {
            readBytesOfDifferences(rows, at);
            return;
        }
        long bit = 8L * at;
        for (int i = 0; i < codes.length; i++) {
            int count = bits[i % bits.length];
            codes[i] = code(rows, bit, count);
            bit += count;
        }
        if (predictor == DIFFERENCES) {
            for (int i = bits.length; i < codes.length; i++) {
                codes[i] = codes[i] + codes[i - bits.length] & ones(bits[i % bits.length]);
            }
        }
    }

    private static long ones(int count) {
        return -1L >>> 64 - count;
    }

    /** A sample's number in the row that was read; whole numbers from 0 to 1. */
    float value(int column, int sample) {
        long code = codes[column * bits.length + sample];
        if (!floating) {
            return (float) (code / largest[sample]);
        }
        return switch (bits[sample]) {
            case 16 -> half((int) code);
            case 32 -> Float.intBitsToFloat((int) code);
            default -> (float) Double.longBitsToDouble(code);
        };
    }

    /** A sample's whole number in the row that was read. */
    long code(int column, int sample) {
        return codes[column * bits.length + sample];
    }

    private long code(byte[] rows, long bit, int count) {
        boolean wholeBytes = count % 8 == 0 && bit % 8 == 0;
        long code = 0;
        if (wholeBytes) {
            int from = (int) (bit / 8);
            int bytes = count / 8;
            for (int i = 0; i < bytes; i++) {
                code = code << 8 | rows[littleEndian ? from + bytes - 1 - i : from + i] & 0xff;
            }
            return code;
        }
        for (long i = bit; i < bit + count; i++) {
            code = code << 1 | rows[(int) (i / 8)] >> 7 - (int) (i % 8) & 1;
        }
        return code;
    }

    /**
     * Undoes differences of neighbouring bytes, which were sorted before: all the highest bytes, then all the next,
     * down to the lowest.
     */
    private void readBytesOfDifferences(byte[] rows, int at) {
        int bytes = bits[0] / 8;
        for (int i = bits.length; i < codes.length * bytes; i++) {
            rows[at + i] += rows[at + i - bits.length];
        }
        for (int i = 0; i < codes.length; i++) {
            codes[i] = 0;
            for (int place = 0; place < bytes; place++) {
                codes[i] = codes[i] << 8 | rows[at + place * codes.length + i] & 0xff;
            }
        }
    }

    /** IEEE 754 with 16 bits: a sign, 5 bits of exponent, 10 of mantissa. */
    private static float half(int code) {
        int exponent = code >> 10 & 0x1f;
        int mantissa = code & 0x3ff;
        float size;
        if (exponent == 0) {
            size = mantissa * 0x1p-24f;
        } else if (exponent == 0x1f) {
            size = mantissa == 0 ? Float.POSITIVE_INFINITY : Float.NaN;
        } else {
            size = Math.scalb(1 + mantissa / 1024f, exponent - 15);
        }
        return code >> 15 == 0 ? size : -size;
    }
}
