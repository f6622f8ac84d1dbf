package tompkins.image;

import java.io.EOFException;
import java.io.IOException;

/**
 * The run lengths of BMP pictures with 4 or 8 bits a pixel. Each code has two bytes: a length and what is repeated, two
 * pixels in turn if they have 4 bits; or 0 and what to do. Pixels that no code reaches have the first colour, and what
 * lies beyond the end of a row, or beyond the last, is passed over.
 */
final class BmpRunLengths {

    private static final int END_OF_ROW = 0;
    private static final int END_OF_PICTURE = 1;
    private static final int JUMP = 2;

    private final byte[] file;
    private final int width;
    private final int rows;
    private final boolean halves;
    private final byte[] indices;
    private int at;
    private long x;
    private long y;

    private BmpRunLengths(byte[] file, int at, int width, int rows, int bits) {
        this.file = file;
        this.at = at;
        this.width = width;
        this.rows = rows;
        this.halves = bits == 4;
        this.indices = new byte[width * rows];
    }

    /**
     * The colours of all pixels, in the order of the file.
     *
     * @param at where the first code lies in the file
     * @throws IOException if the file ends before the picture does
     */
    static byte[] unpack(byte[] file, int at, int width, int rows, int bits) throws IOException {
        BmpRunLengths runs = new BmpRunLengths(file, at, width, rows, bits);
        runs.unpack();
        return runs.indices;
    }

    private void unpack() throws IOException {
        while (!isComplete()) {
            int length = next();
            int value = next();
            if (length > 0) {
                for (int i = 0; i < length; i++) {
                    put(value, i);
                }
            } else if (value == END_OF_PICTURE) {
                return;
            } else if (value == END_OF_ROW) {
                x = 0;
                y++;
            } else if (value == JUMP) {
                x += next();
                y += next();
            } else {
                copy(value);
            }
        }
    }

    /** Whether all rows are there: the code that says so may be missing then. */
    private boolean isComplete() {
        return y >= rows || at == file.length && y == rows - 1 && x >= width;
    }

    private int next() throws IOException {
        if (at >= file.length) {
            throw new EOFException("the file ends inside its pixels");
        }
        return file[at++] & 0xff;
    }

    /** Takes pixels as they are; they are filled up to pairs of bytes. */
    private void copy(int length) throws IOException {
        int value = 0;
        for (int i = 0; i < length; i++) {
            value = halves && i % 2 == 1 ? value : next();
            put(value, i);
        }
        int bytes = halves ? (length + 1) / 2 : length;
        at += bytes % 2;
    }

    private void put(int value, int place) {
        if (x < width && y < rows) {
            int half = place % 2 == 0 ? value >> 4 : value & 0xf;
            indices[(int) (y * width + x)] = (byte) (halves ? half : value);
        }
        x++;
    }
}
