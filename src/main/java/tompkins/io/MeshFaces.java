package tompkins.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.hipparchus.util.ResizableDoubleArray;
import tompkins.io.ObjStatements.ObjMistake;
import tompkins.ray.MeshDetail;
import tompkins.ray.MeshMaterial;

/**
 * Collects what an OBJ file says of its faces, which may come before their vertices, and cuts them into triangles. The
 * axes of an OBJ file are right-handed, those of a scene left-handed: z changes its sign, and the corners of each
 * triangle change their order.
 */
final class MeshFaces {

    private static final int MOST_TRIANGLES = 4_000_000;

    private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d++\\.?\\d*+|\\.\\d++)([eE][+-]?\\d++)?");

    /** Names and groups, which say nothing of what is seen. */
    private static final Set<String> SILENT = Set.of("g", "o", "s", "mg");

    private static final int NONE = -1;

    private final String name;
    private final ObjNotes notes = new ObjNotes();
    private final ObjMaterials library;

    /** The names of materials, which may stand before their library, in order. */
    private final Map<String, Integer> materialNames = new LinkedHashMap<>();

    private int material = NONE;

    private final ResizableDoubleArray coordinates = new ResizableDoubleArray();
    private final ResizableDoubleArray textureCoordinates = new ResizableDoubleArray();
    private final ResizableDoubleArray normals = new ResizableDoubleArray();

    /** Numbers of vertices, texture coordinates and normals, one for each corner of each face. */
    private final IntList corners = new IntList();

    private final IntList textureCorners = new IntList();
    private final IntList normalCorners = new IntList();

    /** For each face the number of corners up to its end, the line where it begins, and its material. */
    private final IntList ends = new IntList();

    private final IntList lines = new IntList();
    private final IntList faceMaterials = new IntList();

    /** The corners of the triangles, as their indices in the lists, and for each triangle its material. */
    private int[] cut = {};

    private final IntList triangleMaterials = new IntList();

    /**
     * No faces yet.
     *
     * @param name the name of the file
     * @param files the files of its materials
     */
    MeshFaces(String name, FileKind.Files files) {
        this.name = name;
        library = new ObjMaterials(files, notes);
    }

    /**
     * Takes all statements.
     *
     * @throws ObjMistake if one is a vertex or face that cannot be used
     */
    void addAll(ObjStatements statements) {
        while (statements.next()) {
            add(statements);
        }
    }

    private void add(ObjStatements statement) {
        if (!statement.nextWord()) {
            return;
        }
        if (statement.wordIs("v")) {
            addVertex(statement);
        } else if (statement.wordIs("f")) {
            addFace(statement);
        } else if (statement.wordIs("vt")) {
            addNumbers(statement, textureCoordinates, 2, "texture coordinates (vt) must be two numbers");
        } else if (statement.wordIs("vn")) {
            addNumbers(statement, normals, 3, "a normal (vn) must be three numbers");
        } else if (statement.wordIs("mtllib")) {
            library.read(name, statement.rest());
        } else if (statement.wordIs("usemtl")) {
            material = materialNames.computeIfAbsent(statement.rest(), named -> materialNames.size());
        } else if (!SILENT.contains(statement.word())) {
            notes.add(name, Problems.quoted(statement.word()) + " is not read");
        }
    }

    private void addVertex(ObjStatements statement) {
        for (int axis = 0; axis < 3; axis++) {
            if (!statement.nextWord()) {
                throw statement.mistake("a vertex must have three coordinates, has " + axis);
            }
            double coordinate = number(statement);
            if (!Double.isFinite(coordinate)) {
                throw statement.mistake(
                        "coordinates must be finite numbers, one was " + Problems.shortened(statement.word()));
            }
            coordinates.addElement(coordinate);
        }
        if (statement.nextWord()) {
            double weight = number(statement);
            if (statement.nextWord()) {
                notes.add(name, "colours of vertices are not shown");
            } else if (weight != 1) {
                notes.add(name, statement.firstLine(), "a vertex must have three coordinates", statement.statement());
            }
        }
    }

    /** The number that a word is; NaN if it is none. */
    private static double number(ObjStatements statement) {
        double number = statement.decimal();
        return Double.isNaN(number) && DECIMAL.matcher(statement.word()).matches()
                ? Double.parseDouble(statement.word())
                : number;
    }

    /** Adds numbers that a mesh can do without: if they cannot be read, they are not a number. */
    private void addNumbers(ObjStatements statement, ResizableDoubleArray numbers, int count, String problem) {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double number = statement.nextWord() ? number(statement) : Double.NaN;
            numbers.addElement(Double.isFinite(number) ? number : Double.NaN);
            sum += numbers.getElement(numbers.getNumElements() - 1);
        }
        if (Double.isNaN(sum)) {
            notes.add(name, statement.firstLine(), problem, statement.statement());
        }
    }

    private void addFace(ObjStatements statement) {
        int start = corners.size();
        while (statement.nextWord()) {
            addCorner(statement);
            if (corners.size() - 2L * (ends.size() + 1) > MOST_TRIANGLES) {
                throw statement.mistake("a mesh may have at most " + MOST_TRIANGLES + " triangles");
            }
        }
        if (corners.size() - start < 3) {
            throw statement.mistake("a face must have three or more corners, has " + (corners.size() - start));
        }
        ends.add(corners.size());
        lines.add(statement.firstLine());
        faceMaterials.add(material);
    }

    /**
     * Adds the numbers of a vertex, its texture coordinates and its normal: 1/2/3, where the last two may be missing.
     */
    private void addCorner(ObjStatements statement) {
        long vertex = statement.wholeNumber();
        long texture = statement.isNext('/') ? statement.wholeNumber() : 0;
        long normal = statement.isNext('/') ? statement.wholeNumber() : 0;
        if (vertex == 0 || !statement.isWordRead()) {
            throw statement.unclear();
        }
        int vertices = coordinates.getNumElements() / 3;
        if (vertex > Integer.MAX_VALUE || vertex < -vertices) {
            String word = statement.word().replaceFirst("/.*", "");
            throw statement.mistake("a face names vertex " + Problems.shortened(word) + ", but there are only "
                    + vertices + " above it");
        }
        corners.add(index(vertex, vertices));
        textureCorners.add(index(texture, textureCoordinates.getNumElements() / 2));
        normalCorners.add(index(normal, normals.getNumElements() / 3));
    }

    /** A number counted from 1, or backwards from the last so far, as one counted from 0; -1 if there is none. */
    private static int index(long number, int known) {
        long index = number > 0 ? number - 1 : number < 0 ? known + number : NONE;
        return index < 0 || index > Integer.MAX_VALUE ? NONE : (int) index;
    }

    /**
     * Checks what can be checked only at the end of the file.
     *
     * @throws ObjMistake if a face names a vertex that is missing
     */
    void requireVertices() {
        int vertices = coordinates.getNumElements() / 3;
        int face = 0;
        for (int i = 0; i < corners.size(); i++) {
            if (i == ends.get(face)) {
                face++;
            }
            if (corners.get(i) >= vertices) {
                throw new ObjMistake(
                        lines.get(face),
                        "a face names vertex " + (corners.get(i) + 1L) + ", but there are only " + vertices);
            }
        }
    }

    /**
     * Cuts the faces into triangles, whose corners run as those of their face.
     *
     * @throws ObjMistake if a face cannot be cut
     */
    void cut() {
        int[] all = corners.toArray();
        FaceTriangulation triangulation =
                new FaceTriangulation(coordinates.getElements(), all.length - 2 * ends.size());
        int start = 0;
        for (int face = 0; face < ends.size(); face++) {
            int size = ends.get(face) - start;
            if (!triangulation.add(all, start, ends.get(face))) {
                throw new ObjMistake(
                        lines.get(face),
                        "a face of " + size + " corners "
                                + (size > FaceTriangulation.MOST_CORNERS
                                        ? "has dents; such a face may have at most " + FaceTriangulation.MOST_CORNERS
                                        : "crosses or touches itself")
                                + "; cut it into triangles");
            }
            start = ends.get(face);
            while (triangleMaterials.size() < triangulation.count()) {
                triangleMaterials.add(faceMaterials.get(face));
            }
        }
        cut = triangulation.triangles();
        for (int i = 0; i < cut.length; i += 3) {
            int second = cut[i + 1];
            cut[i + 1] = cut[i + 2];
            cut[i + 2] = second;
        }
    }

    /** x, y and z of each vertex. */
    double[] vertices() {
        return turnedOver(coordinates);
    }

    private static double[] turnedOver(ResizableDoubleArray vectors) {
        double[] turned = vectors.getElements();
        for (int z = 2; z < turned.length; z += 3) {
            // a subtraction and not a minus sign, which would make negative zeros
            turned[z] = 0 - turned[z];
        }
        return turned;
    }

    /** Three vertices for each triangle. */
    int[] corners() {
        return Arrays.stream(cut).map(corners::get).toArray();
    }

    /** What the triangles have besides their corners. */
    MeshDetail detail() {
        double[] textureValues = textureCoordinates.getElements();
        double[] unitNormals = turnedOver(normals);
        for (int i = 0; i < unitNormals.length; i += 3) {
            double length = Math.hypot(Math.hypot(unitNormals[i], unitNormals[i + 1]), unitNormals[i + 2]);
            for (int axis = i; axis < i + 3; axis++) {
                unitNormals[axis] /= length;
            }
        }
        List<MeshMaterial> materials = new ArrayList<>();
        int[] numbers = materialNames.keySet().stream()
                .mapToInt(named -> number(named, materials))
                .toArray();
        return new MeshDetail(
                textureValues,
                usable(textureCorners, textureValues, 2, "vt"),
                unitNormals,
                usable(normalCorners, unitNormals, 3, "vn"),
                materials,
                materials.isEmpty()
                        ? new int[0]
                        : Arrays.stream(triangleMaterials.toArray())
                                .map(named -> named == NONE ? NONE : numbers[named])
                                .toArray(),
                notes.sentences());
    }

    /** The number that a material gets in a list, or none if there is no such material. */
    private int number(String named, List<MeshMaterial> materials) {
        MeshMaterial known = library.material(named);
        if (known == null) {
            notes.add(name, "there is no material " + Problems.quoted(named));
            return NONE;
        }
        materials.add(known);
        return materials.size() - 1;
    }

    /** The numbers at the corners of the triangles: -1 where there are none; empty if all are. */
    private int[] usable(IntList numbers, double[] values, int count, String key) {
        int[] usable = new int[cut.length];
        boolean some = false;
        for (int i = 0; i < cut.length; i++) {
            int number = numbers.get(cut[i]);
            int from = count * number;
            usable[i] = NONE;
            if (number > NONE && number < values.length / count && isFinite(values, from, count)) {
                usable[i] = number;
                some = true;
            } else if (number > NONE) {
                notes.add(
                        name,
                        "faces name a \"" + key
                                + (key.equals("vn")
                                        ? "\" that is missing, zero or not finite"
                                        : "\" that is missing or not finite"));
            }
        }
        return some ? usable : new int[0];
    }

    private static boolean isFinite(double[] values, int from, int count) {
        double sum = 0;
        for (int i = from; i < from + count; i++) {
            sum += values[i];
        }
        return Double.isFinite(sum);
    }
}
