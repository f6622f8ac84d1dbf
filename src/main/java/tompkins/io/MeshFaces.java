package tompkins.io;

import java.util.Arrays;
import java.util.regex.Pattern;

/** Collects vertices and faces of an OBJ file. Faces may come before their vertices. */
final class MeshFaces {

    private static final int MOST_TRIANGLES = 4_000_000;

    private static final Pattern NUMBER = Pattern.compile(
            "[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?|[+-]?(nan|inf|infinity)", Pattern.CASE_INSENSITIVE);

    /** A vertex, its texture coordinate and its normal. */
    private static final Pattern CORNER = Pattern.compile("[+-]?\\d+(/[+-]?\\d*){0,2}");

    private double[] coordinates = new double[3 * 64];
    private int coordinateCount;
    private int[] corners = new int[3 * 64];
    private int cornerCount;

    /** For each face the number of corners up to its end, and the line where it begins. */
    private int[] ends = new int[64];

    private int[] lines = new int[64];
    private int faceCount;

    /**
     * Takes a statement; those that are neither vertices nor faces are passed over.
     *
     * @throws ObjMistake if it is a vertex or face that cannot be used
     */
    void add(ObjStatements statement) {
        if (!statement.nextWord()) {
            return;
        }
        if (statement.wordIs("v")) {
            addVertex(statement);
        } else if (statement.wordIs("f")) {
            addFace(statement);
        }
    }

    private void addVertex(ObjStatements statement) {
        coordinates = withRoom(coordinates, coordinateCount + 3);
        for (int axis = 0; axis < 3; axis++) {
            if (!statement.nextWord()) {
                throw statement.mistake("a vertex must have three coordinates, has " + axis);
            }
            coordinates[coordinateCount++] = coordinate(statement);
        }
    }

    private static double coordinate(ObjStatements statement) {
        String word = statement.word();
        if (!NUMBER.matcher(word).matches()) {
            throw statement.unclear();
        }
        boolean digits = Character.isDigit(word.charAt(word.length() - 1)) || word.endsWith(".");
        double value = digits ? Double.parseDouble(word) : Double.NaN;
        if (!Double.isFinite(value)) {
            throw statement.mistake("coordinates must be finite, one was " + Problems.shortened(word));
        }
        return value;
    }

    private void addFace(ObjStatements statement) {
        int start = cornerCount;
        while (statement.nextWord()) {
            corners = withRoom(corners, cornerCount + 1);
            corners[cornerCount++] = corner(statement);
            if (cornerCount - 2L * (faceCount + 1) > MOST_TRIANGLES) {
                throw statement.mistake("a mesh may have at most " + MOST_TRIANGLES + " triangles");
            }
        }
        if (cornerCount - start < 3) {
            throw statement.mistake("a face must have three or more corners, has " + (cornerCount - start));
        }
        ends = withRoom(ends, faceCount + 1);
        lines = withRoom(lines, faceCount + 1);
        ends[faceCount] = cornerCount;
        lines[faceCount] = statement.firstLine();
        faceCount++;
    }

    /** The vertex of a corner, counted from 0; it may still be missing. */
    private int corner(ObjStatements statement) {
        String word = statement.word();
        if (!CORNER.matcher(word).matches()) {
            throw statement.unclear();
        }
        int slash = word.indexOf('/');
        String index = slash < 0 ? word : word.substring(0, slash);
        long number = number(index);
        if (number == 0) {
            throw statement.unclear();
        }
        if (number > Integer.MAX_VALUE) {
            throw statement.mistake(
                    "a face names vertex " + Problems.shortened(index) + ", and numbers end at " + Integer.MAX_VALUE);
        }
        int vertices = coordinateCount / 3;
        if (number < -vertices) {
            throw statement.mistake("a face names vertex " + Problems.shortened(index) + ", but there are only "
                    + vertices + " above it");
        }
        return (int) (number > 0 ? number - 1 : vertices + number);
    }

    /** The value of digits with a sign; numbers beyond 64 bits become the nearest that fits. */
    private static long number(String digits) {
        try {
            return Long.parseLong(digits);
        } catch (NumberFormatException tooLong) {
            return digits.startsWith("-") ? Long.MIN_VALUE : Long.MAX_VALUE;
        }
    }

    /**
     * Checks what can be checked only at the end of the file.
     *
     * @throws ObjMistake if a face names a vertex that is missing
     */
    void requireVertices() {
        int vertices = coordinateCount / 3;
        int face = 0;
        for (int i = 0; i < cornerCount; i++) {
            if (i == ends[face]) {
                face++;
            }
            if (corners[i] >= vertices) {
                throw new ObjMistake(
                        lines[face], "a face names vertex " + (corners[i] + 1L) + ", but there are only " + vertices);
            }
        }
    }

    /** x, y and z of each vertex. */
    double[] vertices() {
        return Arrays.copyOf(coordinates, coordinateCount);
    }

    /** Three vertices for each triangle of the faces, in the order in which the corners of its face run. */
    int[] triangles() {
        FaceTriangulation triangulation = new FaceTriangulation(coordinates, cornerCount - 2 * faceCount);
        int start = 0;
        for (int face = 0; face < faceCount; face++) {
            triangulation.add(corners, start, ends[face]);
            start = ends[face];
        }
        return triangulation.triangles();
    }

    private static double[] withRoom(double[] array, int length) {
        return length <= array.length ? array : Arrays.copyOf(array, 2 * array.length);
    }

    private static int[] withRoom(int[] array, int length) {
        return length <= array.length ? array : Arrays.copyOf(array, 2 * array.length);
    }
}
