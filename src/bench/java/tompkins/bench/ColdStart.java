package tompkins.bench;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tompkins.ui.StartBenchmark;

/**
 * How long the program takes with a fresh process, from the start of Java on, to what it was started for; and how long
 * in turns with another jar of the program.
 */
final class ColdStart {

    private static final Path JAR = Path.of("target/tompkins.jar");
    private static final String FIGURE = "scenes/fig1b.json";
    private static final String SQUARE = "scenes/town-square.json";

    private ColdStart() {}

    /**
     * Measures starts with the first scene of the program, for which everybody waits, and with Fig. 1(b).
     *
     * @param starts how many of each
     */
    static void measure(int starts, List<Measure> measures) throws IOException, InterruptedException {
        if (!Files.exists(JAR)) {
            measures.add(Measure.missing("cold start", "there is no " + JAR));
            return;
        }
        addStart("to a 640 x 480 file, town square", file(JAR, SQUARE, 1), starts, measures);
        addStart("to a 640 x 480 file, fig1b", file(JAR, FIGURE, 1), starts, measures);
        if (!Window.isPossible()) {
            measures.add(Measure.missing("cold start to the window", Window.NO_DISPLAY));
            return;
        }
        addStart("to the first picture in the window, town square", window(JAR), starts, measures);
        addStart("to the first picture in the window, fig1b", window(JAR, FIGURE), starts, measures);
    }

    private static void addStart(String what, List<String> command, int starts, List<Measure> measures)
            throws IOException, InterruptedException {
        double[] times = new double[starts];
        for (int i = 0; i < starts; i++) {
            times[i] = milliseconds(command);
        }
        measures.add(Measure.of("cold start " + what, "ms", Measure.median(times)));
    }

    /**
     * Compares with another jar of the program, in turns.
     *
     * @param before the other jar
     * @param turns how often each is started
     */
    static void compare(Path before, int turns, List<Measure> measures) throws IOException, InterruptedException {
        addComparison(
                "fig1a, 256 samples",
                file(JAR, "scenes/fig1a.json", 256),
                file(before, "scenes/fig1a.json", 256),
                turns,
                measures);
        addComparison("fig1b, 256 samples", file(JAR, FIGURE, 256), file(before, FIGURE, 256), turns, measures);
        addComparison("fig1b, cold start to a file", file(JAR, FIGURE, 1), file(before, FIGURE, 1), turns, measures);
        if (Window.isPossible()) {
            // named, since the earlier jar opens with it, and this one with another scene
            addComparison(
                    "fig1b, cold start to the first picture in the window",
                    window(JAR, FIGURE),
                    window(before, FIGURE),
                    turns,
                    measures);
        }
    }

    private static void addComparison(
            String what, List<String> now, List<String> before, int turns, List<Measure> measures)
            throws IOException, InterruptedException {
        double[] times = inTurns(turns, now, before);
        measures.add(Measure.of(what + ", whole command, against the other jar", "x", times[0] / times[1]));
    }

    /** The arguments of Java that take a photograph. */
    private static List<String> file(Path jar, String scene, int samples) {
        return List.of(
                "-jar",
                jar.toString(),
                "render",
                scene,
                "--size",
                "640x480",
                "--samples",
                Integer.toString(samples),
                "--force",
                "-o",
                "target/cold.png");
    }

    /** The arguments of Java that open the window; without a scene the program begins with its own. */
    private static List<String> window(Path jar, String... scene) {
        List<String> arguments = new ArrayList<>(List.of(
                "-Dtompkins.settings=target/cold-settings",
                "-cp",
                jar + File.pathSeparator + Path.of("target/test-classes"),
                StartBenchmark.class.getName()));
        arguments.addAll(List.of(scene));
        return arguments;
    }

    /** The median milliseconds of two commands of Java. */
    private static double[] inTurns(int turns, List<String> first, List<String> second)
            throws IOException, InterruptedException {
        double[][] times = new double[2][turns];
        for (int i = 0; i < turns; i++) {
            times[0][i] = milliseconds(first);
            times[1][i] = milliseconds(second);
        }
        return new double[] {Measure.median(times[0]), Measure.median(times[1])};
    }

    private static double milliseconds(List<String> arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(arguments);
        long start = System.nanoTime();
        int exit = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start()
                .waitFor();
        if (exit != 0) {
            throw new IOException("exit code " + exit + " of " + String.join(" ", command));
        }
        return (System.nanoTime() - start) / 1e6;
    }
}
