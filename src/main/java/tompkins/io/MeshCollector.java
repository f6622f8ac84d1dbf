package tompkins.io;

import de.javagl.obj.AbstractWritableObj;
import de.javagl.obj.FloatTuple;
import de.javagl.obj.ObjFace;
import java.util.Arrays;
import java.util.StringTokenizer;
import tompkins.io.MeshFile.CurrentLine;

/** Takes vertices and faces from the library's reader, into arrays that grow. */
final class MeshCollector extends AbstractWritableObj {

    private static final int MOST_TRIANGLES = 4_000_000;

    private final CurrentLine line;
    private double[] coordinates = new double[3 * 64];
    private int[] corners = new int[3 * 64];
    private int coordinateCount;
    private int cornerCount;
    private int largestIndex = -1;
    private int lineOfLargestIndex;
    private int lineOfMistake;

    MeshCollector(CurrentLine line) {
        this.line = line;
    }

    @Override
    public void addVertex(FloatTuple vertex) {
        if (vertex.getDimensions() < 3) {
            throw new IllegalArgumentException("a vertex must have three coordinates, has " + vertex.getDimensions());
        }
        if (coordinates.length == coordinateCount) {
            coordinates = Arrays.copyOf(coordinates, 2 * coordinateCount);
        }
        StringTokenizer words = new StringTokenizer(line.text());
        words.nextToken();
        for (int axis = 0; axis < 3; axis++) {
            coordinates[coordinateCount++] = exact(vertex.get(axis), words);
        }
    }

    /**
     * The library keeps a float; the digits that it drops are taken from the line, unless that is continued elsewhere.
     */
    private static double exact(float rounded, StringTokenizer words) {
        double exact = words.hasMoreTokens() ? Double.parseDouble(words.nextToken()) : rounded;
        if (!Double.isFinite(exact)) {
            throw new IllegalArgumentException("coordinates must be finite, one was " + exact);
        }
        return (float) exact == rounded ? exact : rounded;
    }

    @Override
    public void addFace(ObjFace face) {
        if (face.getNumVertices() < 3) {
            throw new IllegalArgumentException("a face must have three or more corners, has " + face.getNumVertices());
        }
        for (int corner = 0; corner < face.getNumVertices(); corner++) {
            check(face.getVertexIndex(corner));
        }
        for (int corner = 2; corner < face.getNumVertices(); corner++) {
            if (corners.length == cornerCount) {
                corners = Arrays.copyOf(corners, 2 * cornerCount);
            }
            corners[cornerCount++] = face.getVertexIndex(0);
            corners[cornerCount++] = face.getVertexIndex(corner - 1);
            corners[cornerCount++] = face.getVertexIndex(corner);
        }
        if (cornerCount / 3 > MOST_TRIANGLES) {
            throw new IllegalArgumentException("a mesh may have at most " + MOST_TRIANGLES + " triangles");
        }
    }

    private void check(int index) {
        if (index < 0) {
            throw new IllegalArgumentException(
                    line.text().contains("-")
                            ? "a face counts " + -index + " vertices back beyond the first"
                            : "a face names a vertex beyond number " + Integer.MAX_VALUE);
        }
        if (index > largestIndex) {
            largestIndex = index;
            lineOfLargestIndex = line.getLineNumber();
        }
    }

    /**
     * Checks what only the end of the file tells: faces may come before their vertices.
     *
     * @throws IllegalArgumentException if a vertex is missing
     */
    void requireComplete() {
        int vertices = coordinateCount / 3;
        if (largestIndex >= vertices) {
            lineOfMistake = lineOfLargestIndex;
            throw new IllegalArgumentException(
                    "a face names vertex " + (largestIndex + 1) + ", but there are only " + vertices);
        }
    }

    /** The line of the mistake that an exception reported. */
    int lineOfMistake() {
        return lineOfMistake > 0 ? lineOfMistake : line.getLineNumber();
    }

    double[] vertices() {
        return Arrays.copyOf(coordinates, coordinateCount);
    }

    int[] triangles() {
        return Arrays.copyOf(corners, cornerCount);
    }
}
