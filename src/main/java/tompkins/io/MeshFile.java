package tompkins.io;

import java.io.IOException;
import java.nio.file.Path;
import tompkins.file.FileException;
import tompkins.file.WholeFile;
import tompkins.io.ObjStatements.ObjMistake;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;

/** Reads triangle meshes from OBJ files: faces, cut into triangles, normals, texture coordinates and materials. */
public final class MeshFile {

    /** The bytes of smaller files are kept, so that photographs hold the mesh. */
    static final int LARGEST_KEPT_FILE = 1 << 20;

    private MeshFile() {}

    /**
     * Reads a file from the disk. Its materials must lie in its folder or below.
     *
     * @throws FileException if the file cannot be read, is too large, or is not an OBJ file with triangles
     */
    public static MeshData read(Path file) throws FileException {
        try {
            byte[] content = WholeFile.read(file);
            SceneFolder folder = new SceneFolder(file.toAbsolutePath().getParent());
            return read(content, file.getFileName().toString(), folder::bytes);
        } catch (IOException failure) {
            throw FileException.cannotRead(file, failure);
        }
    }

    /**
     * Reads the bytes of a file. Those of a mesh with materials are not kept, because its materials would be lost.
     *
     * @param name the file's name, for messages and as {@link MeshData#name()}
     * @param others the files of its materials
     * @throws FileException if they are not an OBJ file with triangles
     */
    static MeshData read(byte[] file, String name, FileKind.Files others) throws FileException {
        MeshFaces faces = new MeshFaces(name, others);
        try {
            faces.addAll(new ObjStatements(file));
            faces.requireVertices();
            faces.cut();
        } catch (ObjMistake mistake) {
            throw new FileException(name + ":" + mistake.line() + ": " + mistake.getMessage(), mistake);
        }
        int[] corners = faces.corners();
        if (corners.length == 0) {
            throw new FileException(name + ": not an OBJ file with triangles: it has no lines such as \"f 1 2 3\"");
        }
        MeshDetail detail = faces.detail();
        boolean kept = file.length <= LARGEST_KEPT_FILE && detail.materials().isEmpty();
        return new MeshData(name, faces.vertices(), corners, detail, kept ? file : new byte[0]);
    }
}
