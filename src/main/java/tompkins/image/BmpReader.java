package tompkins.image;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Reads BMP pictures (Microsoft's device-independent bitmaps, all versions). The JDK's reader is not used: it knows no
 * opacity at 16 bits and no mask without bits, guesses the length of a palette from the place of the pixels, and takes
 * run lengths that end too early for a picture.
 */
final class BmpReader {

    private static final int HEADER_AT = 14;
    private static final int OLDEST_HEADER = 12;
    private static final int USUAL_HEADER = 40;
    private static final int HEADER_WITH_MASKS = 52;
    private static final int HEADER_WITH_OPACITY = 56;

    private static final int HEADER_WITH_COLOUR_SPACE = 108;
    private static final int HEADER_WITH_PROFILE = 124;
    private static final int COLOURS_USED_AT = HEADER_AT + 32;

    private static final int PLAIN = 0;
    private static final int RUNS_OF_8_BITS = 1;
    private static final int RUNS_OF_4_BITS = 2;
    private static final int MASKS = 3;
    private static final int JPEG = 4;
    private static final int PNG = 5;
    private static final int MASKS_WITH_OPACITY = 6;

    private final ByteBuffer file;
    private final String name;
    private final long headerLength;
    private final int bits;
    private final int compression;

    private BmpReader(byte[] file, String name) throws IOException {
        this.file = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        this.name = name;
        headerLength = unsigned(HEADER_AT);
        boolean oldest = headerLength == OLDEST_HEADER;
        bits = this.file.getShort(HEADER_AT + (oldest ? 10 : 14)) & 0xffff;
        compression = oldest ? PLAIN : this.file.getInt(HEADER_AT + 16);
        requireReadable();
    }

    private void requireReadable() throws FileException {
        if (headerLength != OLDEST_HEADER
                && headerLength != USUAL_HEADER
                && headerLength != HEADER_WITH_MASKS
                && headerLength != HEADER_WITH_OPACITY
                && headerLength != HEADER_WITH_COLOUR_SPACE
                && headerLength != HEADER_WITH_PROFILE) {
            throw new FileException(name + ": has a header of " + headerLength + " bytes"
                    + (headerLength == 64 ? ", as OS/2 writes it" : "")
                    + "; that of a BMP picture must have 12, 40, 52, 56, 108 or 124");
        }
        if (compression < PLAIN || compression > MASKS_WITH_OPACITY) {
            throw new FileException(name + ": its compression is number " + compression
                    + "; a BMP picture must have none, run lengths, masks, JPEG or PNG (0 to 6)");
        }
        if (!isEmbedded() && bits != 1 && bits != 4 && bits != 8 && bits != 16 && bits != 24 && bits != 32) {
            throw new FileException(
                    name + ": has " + bits + " bits a pixel; a BMP picture must have 1, 4, 8, 16, 24 or 32");
        }
        requireBitsOfCompression();
    }

    /** What the compression demands of the bits. */
    private void requireBitsOfCompression() throws FileException {
        switch (compression) {
            case RUNS_OF_8_BITS -> require(bits == 8, "run lengths", "8");
            case RUNS_OF_4_BITS -> require(bits == 4, "run lengths", "4");
            case MASKS, MASKS_WITH_OPACITY -> require(bits == 16 || bits == 32, "masks", "16 and 32");
            default -> {}
        }
    }

    private void require(boolean fits, String what, String allowed) throws FileException {
        if (!fits) {
            throw new FileException(name + ": has " + what + " and " + bits + (bits == 1 ? " bit" : " bits")
                    + " a pixel; " + what + " are for " + allowed);
        }
    }

    private boolean isEmbedded() {
        return compression == JPEG || compression == PNG;
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        BmpReader reader = new BmpReader(file, name);
        if (reader.isEmbedded()) {
            byte[] embedded = Arrays.copyOfRange(file, reader.pixelsAt(), file.length);
            return reader.compression == JPEG ? JpegReader.read(embedded, name) : PngReader.read(embedded, name);
        }
        return reader.readPixels();
    }

    private int pixelsAt() throws IOException {
        long at = unsigned(10);
        if (at >= file.capacity()) {
            throw new EOFException("the file ends before its pixels");
        }
        if (at < HEADER_AT + headerLength) {
            throw new FileException(name + ": its pixels begin at byte " + at + "; those of a BMP picture must begin"
                    + " after its header, at byte " + (HEADER_AT + headerLength) + " or later");
        }
        return (int) at;
    }

    private long unsigned(int at) {
        return file.getInt(at) & 0xffffffffL;
    }

    private Pixels readPixels() throws IOException {
        boolean oldest = headerLength == OLDEST_HEADER;
        int width = oldest ? file.getShort(HEADER_AT + 4) & 0xffff : file.getInt(HEADER_AT + 4);
        int height = oldest ? file.getShort(HEADER_AT + 6) & 0xffff : file.getInt(HEADER_AT + 8);
        Pixels.requireSize(width, Math.abs((long) height), name);
        int rows = Math.abs(height);
        Pixels stored;
        if (compression == RUNS_OF_8_BITS || compression == RUNS_OF_4_BITS) {
            stored = lookUp(BmpRunLengths.unpack(file.array(), pixelsAt(), width, rows, bits), width, rows);
        } else if (bits <= 8) {
            stored = lookUp(indices(width, rows), width, rows);
        } else {
            stored = readChannels(width, rows);
        }
        return height < 0 ? stored : Orientation.BOTTOM_LEFT.turn(stored);
    }

    /** The bytes of a row, filled up to four; the last row may lack what fills it up. */
    private int rowBytes(int width, int rows) throws IOException {
        long rowBits = width * (long) bits;
        long rowBytes = (rowBits + 31) / 32 * 4;
        if (file.capacity() - pixelsAt() < rowBytes * (rows - 1) + (rowBits + 7) / 8) {
            throw new EOFException("the file ends inside its pixels");
        }
        return (int) rowBytes;
    }

    private byte[] indices(int width, int rows) throws IOException {
        int rowBytes = rowBytes(width, rows);
        byte[] indices = new byte[width * rows];
        int most = (1 << bits) - 1;
        for (int y = 0, to = 0; y < rows; y++) {
            int at = pixelsAt() + rowBytes * y;
            for (int x = 0; x < width; x++, to++) {
                int bit = x * bits;
                indices[to] = (byte) (file.get(at + bit / 8) >> 8 - bits - bit % 8 & most);
            }
        }
        return indices;
    }

    private Pixels lookUp(byte[] indices, int width, int rows) throws IOException {
        float[] palette = palette();
        float[] rgba = new float[4 * indices.length];
        for (int i = 0; i < indices.length; i++) {
            int from = 3 * (indices[i] & 0xff);
            if (from >= palette.length) {
                throw new IOException("a pixel's colour is not in the palette");
            }
            System.arraycopy(palette, from, rgba, 4 * i, 3);
            rgba[4 * i + 3] = 1;
        }
        return new Pixels(width, rows, rgba);
    }

    /** Red, green and blue of all colours in the palette, as many as there is room for before the pixels. */
    private float[] palette() throws IOException {
        boolean oldest = headerLength == OLDEST_HEADER;
        int at = HEADER_AT + (int) headerLength;
        int bytes = oldest ? 3 : 4;
        long told = oldest ? 0 : unsigned(COLOURS_USED_AT);
        int most = 1 << bits;
        int count = Math.min(told == 0 ? most : (int) Math.min(told, most), (pixelsAt() - at) / bytes);
        float[] palette = new float[3 * count];
        for (int i = 0; i < palette.length; i++) {
            palette[i] = (file.get(at + i / 3 * bytes + 2 - i % 3) & 0xff) / 255f;
        }
        return palette;
    }

    private Pixels readChannels(int width, int rows) throws IOException {
        int rowBytes = rowBytes(width, rows);
        long[] masks = masks();
        int bytes = bits / 8;
        float[] rgba = new float[4 * width * rows];
        for (int y = 0, to = 0; y < rows; y++) {
            int at = pixelsAt() + rowBytes * y;
            for (int x = 0; x < width; x++, at += bytes, to += 4) {
                putPixel(littleEndian(at, bytes), masks, rgba, to);
            }
        }
        return new Pixels(width, rows, rgba);
    }

    private long littleEndian(int at, int bytes) {
        long value = 0;
        for (int i = bytes - 1; i >= 0; i--) {
            value = value << 8 | file.get(at + i) & 0xff;
        }
        return value;
    }

    /** The masks of red, green, blue and opacity; one without bits belongs to a channel that is not there. */
    private long[] masks() throws FileException {
        long[] masks = bits == 16 ? new long[] {0x7c00, 0x3e0, 0x1f, 0} : new long[] {0xff0000, 0xff00, 0xff, 0};
        int masksAt = HEADER_AT + USUAL_HEADER;
        if (compression != PLAIN) {
            for (int channel = 0; channel < 3; channel++) {
                masks[channel] = unsigned(masksAt + 4 * channel);
            }
        }
        if (headerLength >= HEADER_WITH_OPACITY || compression == MASKS_WITH_OPACITY) {
            masks[3] = unsigned(masksAt + 12);
        }
        for (int channel = 0; channel < 4; channel++) {
            masks[channel] &= (1L << bits) - 1;
            if (Long.bitCount(masks[channel] + Long.lowestOneBit(masks[channel])) > 1) {
                throw new FileException(name + ": the bits of a channel lie apart in its mask "
                        + Long.toHexString(masks[channel]) + "; those of a BMP picture must lie together");
            }
        }
        return masks;
    }

    private static void putPixel(long pixel, long[] masks, float[] rgba, int to) {
        for (int channel = 0; channel < 4; channel++) {
            rgba[to + channel] = (float) share(pixel, masks[channel]);
        }
        if (masks[3] == 0) {
            rgba[to + 3] = 1;
        }
    }

    private static double share(long pixel, long mask) {
        return mask == 0 ? 0 : (double) (pixel & mask) / mask;
    }
}
