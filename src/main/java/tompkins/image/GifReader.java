package tompkins.image;

import java.io.EOFException;
import java.io.IOException;

/**
 * Reads the first frame of GIF pictures (CompuServe, GIF89a): what the screen shows with it alone, transparent where it
 * does not reach. The JDK's reader is not used: it loses the place of the frame, the rows of low interlaced pictures
 * and pixels that are missing, and says nothing.
 */
final class GifReader {

    private static final int SCREEN_AT = 6;
    private static final int PALETTE_AT = 13;
    private static final int EXTENSION = 0x21;
    private static final int FRAME = 0x2c;
    private static final int CONTROL = 0xf9;
    private static final int HAS_PALETTE = 0x80;
    private static final int INTERLACED = 0x40;
    private static final int TRANSPARENT = 1;

    /** The first row of each pass of an interlaced picture, and the rows from one to the next. */
    private static final int[][] PASSES = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};

    private final byte[] file;
    private final String name;
    private int at = PALETTE_AT;
    private byte[] palette;

    /** The colour that is transparent, or -1. */
    private int transparent = -1;

    private GifReader(byte[] file, String name) {
        this.file = file;
        this.name = name;
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        GifReader reader = new GifReader(file, name);
        reader.readPalette(reader.unsigned(SCREEN_AT + 4));
        reader.goToFrame();
        return reader.readFrame();
    }

    private int unsigned(int place) throws IOException {
        if (place >= file.length) {
            throw new EOFException("the file ends before its pixels");
        }
        return file[place] & 0xff;
    }

    private int littleEndian(int place) throws IOException {
        return unsigned(place) | unsigned(place + 1) << 8;
    }

    /** Reads a palette, if the flags say that there is one: red, green and blue of 2, 4, up to 256 colours. */
    private void readPalette(int flags) throws IOException {
        if ((flags & HAS_PALETTE) != 0) {
            palette = new byte[3 << (flags & 7) + 1];
            for (int i = 0; i < palette.length; i++) {
                palette[i] = (byte) unsigned(at++);
            }
        }
    }

    /** Goes to the first frame; of what comes before, only a transparent colour counts. */
    private void goToFrame() throws IOException {
        for (int block = unsigned(at++); block != FRAME; block = unsigned(at++)) {
            if (block != EXTENSION) {
                throw new IOException("it has no picture");
            }
            if (unsigned(at++) == CONTROL) {
                transparent = (unsigned(at + 1) & TRANSPARENT) == 0 ? -1 : unsigned(at + 4);
            }
            while (unsigned(at) > 0) {
                at += 1 + unsigned(at);
            }
            at++;
        }
    }

    private Pixels readFrame() throws IOException {
        int left = littleEndian(at);
        int top = littleEndian(at + 2);
        int width = littleEndian(at + 4);
        int height = littleEndian(at + 6);
        int flags = unsigned(at + 8);
        at += 9;
        // Some frames reach beyond their screens.
        int screenWidth = Math.max(littleEndian(SCREEN_AT), left + width);
        int screenHeight = Math.max(littleEndian(SCREEN_AT + 2), top + height);
        Pixels.requireSize(width, height, name);
        Pixels.requireSize(screenWidth, screenHeight, name);
        readPalette(flags);
        if (palette == null) {
            throw new FileException(name + ": has no palette; a GIF picture must have one");
        }
        byte[] colours = new GifCodes(file, at).unpack(width * height);
        float[] rgba = new float[4 * screenWidth * screenHeight];
        int[] rows = rows(height, (flags & INTERLACED) != 0);
        for (int row = 0, from = 0; row < height; row++) {
            int to = 4 * ((top + rows[row]) * screenWidth + left);
            for (int x = 0; x < width; x++, from++, to += 4) {
                putPixel(colours[from] & 0xff, rgba, to);
            }
        }
        return new Pixels(screenWidth, screenHeight, rgba);
    }

    /** Which rows of the frame the rows of the file are. */
    private static int[] rows(int height, boolean interlaced) {
        int[] rows = new int[height];
        int[][] passes = interlaced ? PASSES : new int[][] {{0, 1}};
        int row = 0;
        for (int[] pass : passes) {
            for (int y = pass[0]; y < height; y += pass[1]) {
                rows[row++] = y;
            }
        }
        return rows;
    }

    /** A transparent colour keeps its red, green and blue, if the palette has it. */
    private void putPixel(int colour, float[] rgba, int to) throws IOException {
        boolean known = 3 * colour < palette.length;
        if (!known && colour != transparent) {
            throw new IOException("a pixel's colour is not in the palette");
        }
        for (int channel = 0; channel < 3 && known; channel++) {
            rgba[to + channel] = (palette[3 * colour + channel] & 0xff) / 255f;
        }
        rgba[to + 3] = colour == transparent ? 0 : 1;
    }
}
