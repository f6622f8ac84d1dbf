package tompkins.image;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;

/**
 * One chunk of a PNG file: length, type, data, check sum (PNG specification, section 5.3).
 *
 * @param type four letters
 * @param data the content, without length and check sum
 */
record PngChunk(String type, byte[] data) {

    /** How many bytes a chunk has besides its data. */
    static final long FRAME = 12;

    /** The bytes before the first chunk. */
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /** Where the first chunk begins. */
    static final int SIGNATURE_LENGTH = SIGNATURE.length;

    /** The chunks of a PNG file up to the last; what lies behind that is not of the picture. */
    static List<PngChunk> all(byte[] png) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(png));
        skipSignature(in);
        List<PngChunk> chunks = new ArrayList<>();
        do {
            int place = png.length - in.available();
            int length = in.readInt();
            chunks.add(read(in, readType(in), length, place));
        } while (!chunks.get(chunks.size() - 1).type.equals("IEND"));
        return chunks;
    }

    /** Begins a PNG file. */
    static void writeSignature(OutputStream out) throws IOException {
        out.write(SIGNATURE);
    }

    /** Goes to the first chunk, and returns the place where it begins. */
    static int skipSignature(InputStream in) throws IOException {
        return in.readNBytes(SIGNATURE.length).length;
    }

    /** The four letters of a type, with the length before it already read. */
    static String readType(DataInputStream in) throws IOException {
        byte[] letters = new byte[4];
        in.readFully(letters);
        return new String(letters, StandardCharsets.ISO_8859_1);
    }

    /** The rest of a chunk, whose length and type are already read; the place is that of its first byte in the file. */
    static PngChunk read(DataInputStream in, String type, int length, long place) throws IOException {
        byte[] data = in.readNBytes(length);
        if (data.length < length) {
            throw new EOFException("the file ends inside a chunk");
        }
        PngChunk chunk = new PngChunk(type, data);
        if (in.readInt() != chunk.checksum()) {
            throw damaged(place);
        }
        return chunk;
    }

    /** What to say about a file if its chunk at a place has changed since it was written. */
    static IOException damaged(long place) {
        return new IOException(
                "the file is damaged in the part that begins at byte " + place + "; another copy of it may be intact");
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
    int checksum() {
        CRC32 sum = new CRC32();
        sum.update(letters());
        sum.update(data);
        return (int) sum.getValue();
    }
}
