package tompkins.image;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Reads BMP pictures (Microsoft's device-independent bitmaps, all versions). Pixels of 16 and 32 bits, whose channels
 * are given by masks, are read here, because the JDK's reader knows no opacity at 16 bits and no mask without bits. It
 * reads the others.
 */
final class BmpReader {

    private static final int HEADER_AT = 14;
    private static final int OLDEST_HEADER = 12;
    private static final int USUAL_HEADER = 40;
    private static final int HEADER_WITH_MASKS = 52;
    private static final int HEADER_WITH_OPACITY = 56;

    private static final int HEADER_WITH_COLOUR_SPACE = 108;
    private static final int HEADER_WITH_PROFILE = 124;
    private static final int COLOUR_SPACE_AT = HEADER_AT + 56;
    private static final int SRGB = 0x73524742;

    private static final int PLAIN = 0;
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
        return reader.bits == 16 || reader.bits == 32
                ? reader.readMasked()
                : LibraryReader.read(PictureEncoding.BMP, reader.withoutProfile(), name);
    }

    /**
     * The file with a header that says that its colours are those of screens, so that nothing has to understand its
     * profile.
     */
    private byte[] withoutProfile() {
        byte[] plain = file.array().clone();
        if (headerLength >= HEADER_WITH_COLOUR_SPACE) {
            ByteBuffer.wrap(plain).order(ByteOrder.LITTLE_ENDIAN).putInt(COLOUR_SPACE_AT, SRGB);
        }
        return plain;
    }

    private int pixelsAt() throws IOException {
        long at = unsigned(10);
        if (at >= file.capacity()) {
            throw new EOFException("the file ends before its pixels");
        }
        return (int) at;
    }

    private long unsigned(int at) {
        return file.getInt(at) & 0xffffffffL;
    }

    private Pixels readMasked() throws IOException {
        if (compression != PLAIN && compression != MASKS && compression != MASKS_WITH_OPACITY) {
            throw new FileException(name + ": has run lengths and " + bits + " bits a pixel; run lengths are for "
                    + (compression == RUNS_OF_4_BITS ? 4 : 8));
        }
        int width = headerLength == OLDEST_HEADER ? file.getShort(HEADER_AT + 4) : file.getInt(HEADER_AT + 4);
        int height = headerLength == OLDEST_HEADER ? file.getShort(HEADER_AT + 6) : file.getInt(HEADER_AT + 8);
        Pixels.requireSize(width, Math.abs((long) height), name);
        long[] masks = masks();
        int rows = Math.abs(height);
        int bytes = bits / 8;
        long rowBytes = (width * (long) bytes + 3) / 4 * 4;
        int start = pixelsAt();
        // The last row may lack its padding.
        if (file.capacity() - start < rowBytes * (rows - 1) + (long) width * bytes) {
            throw new EOFException("the file ends inside its pixels");
        }
        float[] rgba = new float[4 * width * rows];
        for (int y = 0, to = 0; y < rows; y++) {
            int at = start + (int) rowBytes * (height < 0 ? y : rows - 1 - y);
            for (int x = 0; x < width; x++, at += bytes, to += 4) {
                putPixel(bits == 16 ? file.getShort(at) & 0xffff : unsigned(at), masks, rgba, to);
            }
        }
        return new Pixels(width, rows, rgba);
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
