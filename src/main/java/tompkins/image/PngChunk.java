package tompkins.image;

import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;

/**
 * One chunk of a PNG file: length, type, data, check sum (PNG specification, section 5.3).
 *
 * @param type four letters
 * @param data the content, without length and check sum
 */
record PngChunk(String type, byte[] data) {

    /** How many bytes a chunk has besides its data. */
    private static final int FRAME = 12;

    /** The bytes before the first chunk. */
    static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /**
     * The chunk that begins at a place of a PNG file.
     *
     * @throws IOException if it has changed since it was written
     */
    static PngChunk at(byte[] png, int place) throws IOException {
        ByteBuffer file = ByteBuffer.wrap(png).position(place);
        int length = file.getInt();
        if (length < 0) {
            throw damaged(place);
        }
        if (length > file.remaining() - Integer.BYTES - Integer.BYTES) {
            throw new EOFException("the file ends inside a chunk");
        }
        byte[] letters = new byte[4];
        byte[] data = new byte[length];
        file.get(letters).get(data);
        PngChunk chunk = new PngChunk(new String(letters, StandardCharsets.ISO_8859_1), data);
        if (file.getInt() != chunk.checksum()) {
            throw damaged(place);
        }
        return chunk;
    }

    private static IOException damaged(int place) {
        return new IOException(
                "the file is damaged in the part that begins at byte " + place + "; another copy of it may be intact");
    }

    /** The bytes that it takes in a file. */
    int size() {
        return data.length + FRAME;
    }

    /** Whether it ends the file; what lies behind it is not of the picture. */
    boolean isLast() {
        return type.equals("IEND");
    }

    void write(OutputStream out) throws IOException {
        DataOutputStream chunk = new DataOutputStream(out);
        chunk.writeInt(data.length);
        chunk.write(letters());
        chunk.write(data);
        chunk.writeInt(checksum());
    }

    private byte[] letters() {
        return type.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** The check sum of type and data. */
    private int checksum() {
        CRC32 sum = new CRC32();
        sum.update(letters());
        sum.update(data);
        return (int) sum.getValue();
    }
}
