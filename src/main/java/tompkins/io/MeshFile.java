package tompkins.io;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import tompkins.image.FileException;
import tompkins.image.WholeFile;
import tompkins.ray.MeshData;

/**
 * Reads triangle meshes from OBJ files: vertices and faces, which are cut into triangles. The axes of an OBJ file are
 * right-handed, those of a scene left-handed: z changes its sign, and the corners of each triangle change their order.
 */
public final class MeshFile {

    /** The bytes of smaller files are kept, so that photographs hold the mesh. */
    static final int LARGEST_KEPT_FILE = 1 << 20;

    private MeshFile() {}

    /**
     * Reads a file from the disk.
     *
     * @throws FileException if the file cannot be read, is too large, or is not an OBJ file with triangles
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
     * @throws FileException if they are not an OBJ file with triangles
     */
    static MeshData read(byte[] file, String name) throws FileException {
        MeshFaces faces = new MeshFaces();
        ObjStatements statements = new ObjStatements(
                new BufferedReader(new InputStreamReader(new ByteArrayInputStream(file), StandardCharsets.UTF_8)));
        try {
            while (statements.next()) {
                faces.add(statements);
            }
            faces.requireVertices();
        } catch (ObjMistake mistake) {
            throw new FileException(name + ":" + mistake.line() + ": " + mistake.getMessage(), mistake);
        } catch (IOException impossible) {
            throw FileException.cannotRead(Path.of(name), impossible);
        }
        int[] corners = faces.triangles();
        if (corners.length == 0) {
            throw new FileException(name + ": not an OBJ file with triangles: it has no lines such as \"f 1 2 3\"");
        }
        double[] coordinates = faces.vertices();
        turnOver(coordinates, corners);
        byte[] kept = file.length <= LARGEST_KEPT_FILE ? file : new byte[0];
        return new MeshData(name, coordinates, corners, kept);
    }

    /** From right-handed axes to left-handed ones, with the outside of each triangle kept. */
    private static void turnOver(double[] coordinates, int[] corners) {
        for (int z = 2; z < coordinates.length; z += 3) {
            // a subtraction and not a minus sign, which would make negative zeros
            coordinates[z] = 0 - coordinates[z];
        }
        for (int i = 0; i < corners.length; i += 3) {
            int second = corners[i + 1];
            corners[i + 1] = corners[i + 2];
            corners[i + 2] = second;
        }
    }
}
