package tompkins.image;

import java.io.EOFException;
import java.io.IOException;

/**
 * The packed pixels of a GIF frame: codes of 3 to 12 bits, the lowest bit first, in blocks that begin with their length
 * (GIF89a, appendix F: variable-length-code LZW). Each code is a colour or a chain of colours that came before.
 */
final class GifCodes {

    private static final int MOST_CODES = 4096;
    private static final int MOST_BITS_OF_COLOUR = 8;

    private final byte[] file;
    private int at;
    private int leftInBlock;
    private int bits;
    private int bitCount;

    /** The chain of each code: what comes before its last colour, that colour, its first colour and its length. */
    private final short[] before = new short[MOST_CODES];

    private final byte[] last = new byte[MOST_CODES];
    private final byte[] first = new byte[MOST_CODES];
    private final short[] length = new short[MOST_CODES];

    /** Codes that begin at a place of a file, with the bits of a colour. */
    GifCodes(byte[] file, int at) {
        this.file = file;
        this.at = at;
    }

    /**
     * The colours of the first pixels.
     *
     * @throws IOException if there are fewer, or a code that stands for nothing
     */
    byte[] unpack(int count) throws IOException {
        int colourBits = next();
        if (colourBits < 1 || colourBits > MOST_BITS_OF_COLOUR) {
            throw new IOException("its colours have " + colourBits + " bits, and must have from 1 to 8");
        }
        int clear = 1 << colourBits;
        for (int code = 0; code < clear; code++) {
            last[code] = (byte) code;
            first[code] = (byte) code;
            length[code] = 1;
        }
        byte[] colours = new byte[count];
        int filled = 0;
        int known = clear + 2;
        int codeBits = colourBits + 1;
        int previous = -1;
        while (filled < count) {
            int code = nextCode(codeBits);
            if (code == clear) {
                known = clear + 2;
                codeBits = colourBits + 1;
                previous = -1;
                continue;
            }
            if (code == clear + 1) {
                throw new EOFException("pixels are missing");
            }
            if (previous >= 0 && known < MOST_CODES) {
                before[known] = (short) previous;
                first[known] = first[previous];
                length[known] = (short) (length[previous] + 1);
                last[known] = first[code == known ? previous : code];
                known++;
            }
            if (code >= known || code > clear && previous < 0) {
                throw new IOException("a code of its pixels stands for nothing");
            }
            filled += put(code, colours, filled);
            if (known == 1 << codeBits && known < MOST_CODES) {
                codeBits++;
            }
            previous = code;
        }
        return colours;
    }

    /** Writes the chain of a code, as far as there is room, and returns its length. */
    private int put(int code, byte[] colours, int from) {
        int link = code;
        for (int to = from + length[code] - 1; to >= from; to--) {
            if (to < colours.length) {
                colours[to] = last[link];
            }
            link = before[link];
        }
        return length[code];
    }

    private int nextCode(int count) throws IOException {
        while (bitCount < count) {
            while (leftInBlock == 0) {
                leftInBlock = next();
                if (leftInBlock == 0) {
                    throw new EOFException("pixels are missing");
                }
            }
            leftInBlock--;
            bits |= next() << bitCount;
            bitCount += 8;
        }
        int code = bits & (1 << count) - 1;
        bits >>>= count;
        bitCount -= count;
        return code;
    }

    private int next() throws IOException {
        if (at >= file.length) {
            throw new EOFException("the file ends inside its pixels");
        }
        return file[at++] & 0xff;
    }
}
