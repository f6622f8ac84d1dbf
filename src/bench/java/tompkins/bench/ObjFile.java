package tompkins.bench;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import tompkins.io.StudioReader;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** A mesh on its whole way: from an OBJ file through the reader of scenes to the first picture. */
final class ObjFile {

    private static final int TRIANGLES = 1_000_000;
    private static final String MESH = "mesh.obj";

    private ObjFile() {}

    /** Measures in this process, and prints the seconds to read the scene, and until its picture is taken. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path scene = Path.of(arguments[0]);
        long start = System.nanoTime();
        Studio studio = StudioReader.read(scene);
        double read = seconds(start);
        try (Renderer renderer = new Renderer()) {
            renderer.render(RenderPlan.of(studio));
        }
        System.out.println(read + " " + seconds(start));
    }

    private static double seconds(long start) {
        return (System.nanoTime() - start) / 1e9;
    }

    /** Writes the triangles of a sphere with a scene around them, and takes cold photographs of it. */
    static void measure(int rounds, List<Measure> measures) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("obj");
        Path file = folder.resolve(MESH);
        Path scene = folder.resolve("scene.json");
        int rings = Growth.rings(TRIANGLES);
        write(Growth.coordinates(rings), Growth.corners(rings), file);
        Files.writeString(scene, "{\"scene\": [{\"type\": \"TriangleMesh\", \"mesh\": \"" + MESH + "\"}]}");
        double[][] seconds = new double[2][rounds];
        for (int round = 0; round < rounds; round++) {
            double[] numbers = OwnProcess.numbers(ObjFile.class, scene.toString());
            for (int i = 0; i < numbers.length; i++) {
                seconds[i][round] = numbers[i];
            }
        }
        Files.delete(scene);
        Files.delete(file);
        Files.delete(folder);
        double whole = Measure.median(seconds[1]);
        measures.add(
                Measure.of("an OBJ file of a million triangles, cold: scene read", "s", Measure.median(seconds[0])));
        measures.add(Measure.of("the same: picture taken", "s", whole));
    }

    private static void write(double[] coordinates, int[] corners, Path file) throws IOException {
        try (BufferedWriter out = Files.newBufferedWriter(file)) {
            for (int i = 0; i < coordinates.length; i += 3) {
                // who reads it turns z over; otherwise the sphere would stand behind the camera
                out.write("v " + coordinates[i] + " " + coordinates[i + 1] + " " + -coordinates[i + 2] + "\n");
            }
            for (int i = 0; i < corners.length; i += 3) {
                out.write("f " + (corners[i] + 1) + " " + (corners[i + 1] + 1) + " " + (corners[i + 2] + 1) + "\n");
            }
        }
    }
}
