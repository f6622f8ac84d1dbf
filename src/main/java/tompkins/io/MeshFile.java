package tompkins.io;

import de.javagl.obj.ObjReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.LineNumberReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import tompkins.image.FileException;
import tompkins.image.WholeFile;
import tompkins.ray.MeshData;

/** Reads triangle meshes from OBJ files: vertices and faces; faces with more corners are cut into fans of triangles. */
public final class MeshFile {

    /** The bytes of smaller files are kept, so that photographs hold the mesh. */
    static final int LARGEST_KEPT_FILE = 1 << 20;

    private MeshFile() {}

    /**
     * Reads a file from the disk.
     *
     * @throws FileException if the file cannot be read, is too large, or is no OBJ file with triangles
     */
    public static MeshData read(Path file) throws FileException {
        try {
            return read(WholeFile.read(file), file.getFileName().toString());
        } catch (IOException failure) {
            throw FileException.cannotRead(file, failure);
        }
    }

    /**
     * Reads the bytes of a file.
     *
     * @param name the file's name, for messages and as {@link MeshData#name()}
     * @throws FileException if they are no OBJ file with triangles
     */
    static MeshData read(byte[] file, String name) throws FileException {
        InputStream bytes = new ByteArrayInputStream(file);
        CurrentLine line = new CurrentLine(new InputStreamReader(bytes, StandardCharsets.UTF_8));
        MeshCollector collector = new MeshCollector(line);
        try {
            ObjReader.read(line, collector);
            collector.requireComplete();
        } catch (IOException | RuntimeException mistake) {
            String place = name + ":" + collector.lineOfMistake();
            throw new FileException(place + ": " + reason(mistake, line.text()), mistake);
        }
        int[] triangles = collector.triangles();
        if (triangles.length == 0) {
            throw new FileException(name + ": not an OBJ file with triangles: it has no lines such as \"f 1 2 3\"");
        }
        byte[] kept = file.length <= LARGEST_KEPT_FILE ? file : new byte[0];
        return new MeshData(name, collector.vertices(), triangles, kept);
    }

    /**
     * What the collector refuses it says itself; the library tells of its own classes, so the line is shown instead.
     */
    private static String reason(Exception mistake, String line) {
        boolean clear = mistake instanceof IllegalArgumentException && !(mistake instanceof NumberFormatException);
        return clear
                ? mistake.getMessage()
                : Problems.quoted(line) + " cannot be understood; a vertex is written like \"v 0 1.5 -2\", a face like"
                        + " \"f 1 2 3\" with vertices counted from 1";
    }

    /**
     * Remembers the line that was read last. Byte order marks, comments, and the normals and texture coordinates that a
     * mesh does without never come to the library, which would stumble over some.
     */
    static final class CurrentLine extends LineNumberReader {

        private static final String BYTE_ORDER_MARK = "\uFEFF";

        private String text = "";

        CurrentLine(InputStreamReader in) {
            super(in);
        }

        @Override
        public String readLine() throws IOException {
            String next = super.readLine();
            if (next == null) {
                return null;
            }
            String marked = next.startsWith(BYTE_ORDER_MARK) ? next.substring(1) : next;
            int comment = marked.indexOf('#');
            String plain = (comment < 0 ? marked : marked.substring(0, comment)).stripLeading();
            text = plain.startsWith("vn") || plain.startsWith("vt") ? "" : plain;
            return text;
        }

        String text() {
            return text;
        }
    }
}
