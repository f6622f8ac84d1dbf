package tompkins.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3i;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.TriangleMesh;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;

/**
 * How time grows with the number of objects: fields of spheres, lattices of rods, meshes of triangles. Each scene has a
 * process of its own.
 */
final class Growth {

    /** Among a million primitives the tree answers for the lamps for three seconds, until their cells are filled. */
    private static final double SECONDS = 7;

    private static final int FEWEST = 100;
    private static final int MOST = 1_000_000;
    private static final int[] SIZES = {FEWEST, 10_000, MOST};

    private static final String RODS = "rods";
    private static final String TRIANGLES = "triangles";
    private static final List<String> NAMES = List.of("spheres", RODS, TRIANGLES);

    private static final String HEAD = """

            ## Growth

            Time of a whole 640 x 480 picture with shadows on two threads, per ray; spheres and rods get thinner where there are more.

            | scene | objects | ns per ray | plan and tree, ms |
            | --- | --- | --- | --- |
            """;

    private Growth() {}

    /** Measures one scene in this process, and prints two numbers. */
    public static void main(String[] arguments) throws InterruptedException {
        int size = Integer.parseInt(arguments[1]);
        SceneObject scene = scene(arguments[0], size);
        Studio studio = PaperStudios.fig1a().withScene(List.of(scene));
        // what is loaded and compiled for the first plan is not counted
        RenderPlan plan = RenderPlan.of(studio);
        double build = Double.POSITIVE_INFINITY;
        for (int attempt = 0; attempt < 3; attempt++) {
            plan = null;
            long start = System.nanoTime();
            plan = RenderPlan.of(studio);
            build = Math.min(build, (System.nanoTime() - start) / 1e6);
        }
        System.out.println(OwnProcess.nanosecondsPerRay(plan, SECONDS) + " " + build);
    }

    private static SceneObject scene(String name, int size) {
        return switch (name) {
            case "spheres" -> spheres(size);
            case RODS -> rods(size);
            default -> triangles(size);
        };
    }

    /**
     * Measures all in turns, adds how the time grows, and gives the whole table as Markdown.
     *
     * @param rounds how often to measure the fewest and the most
     */
    static String measure(int rounds, List<Measure> measures) throws IOException, InterruptedException {
        Map<String, List<double[]>> turns = new HashMap<>();
        for (int round = 0; round < rounds; round++) {
            for (String name : NAMES) {
                for (int size : SIZES) {
                    if (round == 0 || size == FEWEST || size == MOST) {
                        turns.computeIfAbsent(name + size, any -> new ArrayList<>())
                                .add(OwnProcess.numbers(Growth.class, name, Integer.toString(size)));
                    }
                }
            }
        }
        StringBuilder table = new StringBuilder(HEAD);
        for (String name : NAMES) {
            for (int size : SIZES) {
                addRow(table, name, size, turns.get(name + size));
            }
        }
        double fewest = median(turns.get(NAMES.get(0) + FEWEST), 0);
        double most = median(turns.get(NAMES.get(0) + MOST), 0);
        measures.add(Measure.of("spheres: time per ray at 1e6 to that at 1e2", "x", most / fewest));
        ObjFile.measure(rounds, measures);
        return table.toString();
    }

    private static void addRow(StringBuilder table, String name, int size, List<double[]> turns) {
        table.append("| " + name + " | " + size + " | " + Measure.number(median(turns, 0)) + " | "
                + Measure.number(median(turns, 1)) + " |\n");
    }

    private static double median(List<double[]> turns, int number) {
        return Measure.median(turns.stream().map(numbers -> numbers[number]).toList());
    }

    /** Spheres at random, smaller where there are more, so that they fill the same part of space. */
    private static SceneObject spheres(int count) {
        Random random = new Random(count);
        List<SceneObject> spheres = new ArrayList<>();
        double radius = 1 / Math.cbrt(count);
        for (int i = 0; i < count; i++) {
            Vector3d centre =
                    new Vector3d(random.nextDouble(-2, 2), random.nextDouble(-1.5, 1.5), random.nextDouble(8, 12));
            spheres.add(new Sphere("sphere", centre, radius, ColouredSurface.DEFAULT));
        }
        return new Group("field", spheres);
    }

    /**
     * Three equal families of rods, thinner where there are more. Their number along an axis is even, since the pinhole
     * would be inside a rod otherwise, and see nothing else.
     */
    private static SceneObject rods(int count) {
        int side = 2 * (int) Math.round(Math.sqrt(count / 12.0));
        CylinderLattice usual = CylinderLattice.DEFAULT;
        return new CylinderLattice(
                "lattice",
                usual.from(),
                usual.to(),
                new Vector3i(side),
                0.1 / side,
                usual.surfaceAlongX(),
                usual.surfaceAlongY(),
                usual.surfaceAlongZ());
    }

    private static SceneObject triangles(int count) {
        int rings = rings(count);
        MeshData mesh = new MeshData("sphere.obj", coordinates(rings), corners(rings), MeshDetail.NONE, new byte[0]);
        return new TriangleMesh("sphere", mesh, ColouredSurface.DEFAULT, true);
    }

    /** Rings of a sphere that is made of about so many triangles; each ring has twice as many vertices. */
    static int rings(int triangles) {
        return (int) Math.round(Math.sqrt(triangles / 4.0));
    }

    /** Three coordinates of each vertex of such rings. */
    static double[] coordinates(int rings) {
        int columns = 2 * rings;
        double[] coordinates = new double[3 * (rings + 1) * columns];
        for (int vertex = 0; vertex < (rings + 1) * columns; vertex++) {
            double latitude = Math.PI * (vertex / columns) / rings;
            double longitude = 2 * Math.PI * (vertex % columns) / columns;
            coordinates[3 * vertex] = Math.sin(latitude) * Math.cos(longitude);
            coordinates[3 * vertex + 1] = Math.cos(latitude);
            coordinates[3 * vertex + 2] = 10 + Math.sin(latitude) * Math.sin(longitude);
        }
        return coordinates;
    }

    /** The vertices of each triangle of such rings, counted from 0. */
    static int[] corners(int rings) {
        int columns = 2 * rings;
        return IntStream.range(0, rings * columns)
                .flatMap(vertex -> {
                    int right = vertex - vertex % columns + (vertex + 1) % columns;
                    int below = vertex + columns;
                    return IntStream.of(vertex, right, below, right, right + columns, below);
                })
                .toArray();
    }
}
