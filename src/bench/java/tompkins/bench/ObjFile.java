package tompkins.bench;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import tompkins.io.StudioReader;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** A mesh on its whole way: from an OBJ file through the reader of scenes to the first picture. */
final class ObjFile {

    private ObjFile() {}

    /**
     * Writes triangles as an OBJ file with a scene around it, takes its photograph, and tells what that took.
     *
     * @param coordinates x, y and z of each vertex
     * @param corners three numbers of vertices, counted from 0, for each triangle
     */
    static String measure(double[] coordinates, int[] corners) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("obj");
        Path file = folder.resolve("mesh.obj");
        Path scene = folder.resolve("scene.json");
        write(coordinates, corners, file);
        Files.writeString(scene, "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"mesh.obj\"}]}");
        long start = System.nanoTime();
        Studio studio = StudioReader.read(scene);
        double read = (System.nanoTime() - start) / 1e9;
        start = System.nanoTime();
        try (Renderer renderer = new Renderer()) {
            renderer.render(RenderPlan.of(studio));
        }
        double taken = (System.nanoTime() - start) / 1e9;
        double megabytes = Files.size(file) / 1e6;
        Files.delete(scene);
        Files.delete(file);
        Files.delete(folder);
        return String.format(
                Locale.ROOT,
                "An OBJ file of %d triangles (%.0f MB) is read with its scene in %.2f s; tree and picture take %.2f s more.%n",
                corners.length / 3,
                megabytes,
                read,
                taken);
    }

    private static void write(double[] coordinates, int[] corners, Path file) throws IOException {
        try (BufferedWriter out = Files.newBufferedWriter(file)) {
            for (int i = 0; i < coordinates.length; i += 3) {
                out.write("v " + coordinates[i] + " " + coordinates[i + 1] + " " + coordinates[i + 2] + "\n");
            }
            for (int i = 0; i < corners.length; i += 3) {
                out.write("f " + (corners[i] + 1) + " " + (corners[i + 1] + 1) + " " + (corners[i + 2] + 1) + "\n");
            }
        }
    }
}
