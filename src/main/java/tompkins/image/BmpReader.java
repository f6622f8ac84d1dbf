package tompkins.image;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import tompkins.file.FileException;

/**
 * Reads BMP pictures (Microsoft's device-independent bitmaps) of 16, 24 and 32 bits a pixel with the JDK's reader. That
 * reader guesses where a file does not say what it needs, so the header must say all of it.
 */
final class BmpReader {

    private static final int HEADER_AT = 14;
    private static final int USUAL_HEADER = 40;
    private static final int HEADER_WITH_COLOUR_SPACE = 108;
    private static final int HEADER_WITH_PROFILE = 124;
    private static final int PLAIN = 0;
    private static final int MASKS = 3;

    private final ByteBuffer header;
    private final String name;
    private final int bits;

    private BmpReader(byte[] file, String name) {
        header = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        this.name = name;
        bits = header.getShort(HEADER_AT + 14) & 0xffff;
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        new BmpReader(file, name).requireReadable();
        return PixelDecoder.decode(
                LibraryReader.image(PictureEncoding.BMP, file, name).getRaster(), null);
    }

    private void requireReadable() throws IOException {
        long length = header.getInt(HEADER_AT);
        require(
                length == USUAL_HEADER || length == HEADER_WITH_COLOUR_SPACE || length == HEADER_WITH_PROFILE,
                "has a header of " + length + " bytes",
                "have one of 40, 108 or 124");
        require(bits == 16 || bits == 24 || bits == 32, "has " + bits + " bits a pixel", "have 16, 24 or 32");
        int compression = header.getInt(HEADER_AT + 16);
        boolean masks = compression == MASKS && bits != 24;
        require(masks || compression == PLAIN, "its compression is number " + compression, "have none");
        if (masks) {
            for (int channel = 0; channel < 3; channel++) {
                requireMask(header.getInt(HEADER_AT + USUAL_HEADER + 4 * channel));
            }
            boolean opacity = length > USUAL_HEADER && header.getInt(HEADER_AT + 52) != 0;
            require(!opacity || bits == 32, "has opacity in 16 bits", "have 32 bits for that");
        }
        requireWhole();
    }

    /** The bits of a channel must be there, and lie together. */
    private void requireMask(int mask) throws FileException {
        long bitsOf = mask & 0xffffffffL;
        boolean together = Long.bitCount(bitsOf + Long.lowestOneBit(bitsOf)) <= 1;
        require(
                mask != 0 && together,
                "the mask of a channel is " + Long.toHexString(bitsOf),
                "have bits for each, side by side");
    }

    private void requireWhole() throws IOException {
        long width = header.getInt(HEADER_AT + 4);
        long height = Math.abs((long) header.getInt(HEADER_AT + 8));
        Pixels.requireSize(width, height, name);
        long rowBytes = (width * bits + 31) / 32 * 4;
        // the last row may lack what fills it up
        if (header.capacity() - (header.getInt(10) & 0xffffffffL) < rowBytes * (height - 1) + (width * bits + 7) / 8) {
            throw new EOFException("the file ends inside its pixels");
        }
    }

    private void require(boolean known, String property, String allowed) throws FileException {
        PictureEncoding.BMP.require(known, name, property, allowed);
    }
}
