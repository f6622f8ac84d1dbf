package tompkins.bench;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** How long the program takes with a fresh process, from the start of Java on, to what it was started for. */
final class ColdStart {

    private static final Path JAR = Path.of("target/tompkins.jar");
    private static final String FIGURE = "scenes/fig1b.json";
    private static final String WINDOW = "tompkins.ui.StartBenchmark";

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
        file("town square", "scenes/town-square.json", starts, measures);
        file("fig1b", FIGURE, starts, measures);
        if (!Window.isPossible()) {
            measures.add(Measure.missing("cold start to the window", Window.NO_DISPLAY));
            return;
        }
        window("town square", List.of(), starts, measures);
        window("fig1b", List.of(FIGURE), starts, measures);
    }

    /** To the end of a photograph that was saved. */
    private static void file(String name, String scene, int starts, List<Measure> measures)
            throws IOException, InterruptedException {
        Path picture = Files.createTempFile("cold", ".png");
        double time = milliseconds(
                starts,
                List.of("-jar", JAR.toString()),
                List.of("render", scene, "--size", "640x480", "--samples", "1", "--force", "-o", picture.toString()));
        Files.delete(picture);
        measures.add(Measure.atMost("cold start to a 640 x 480 file, " + name, 900, "ms", time));
    }

    /** To the first picture in the window; without arguments the program begins with its own scene. */
    private static void window(String name, List<String> arguments, int starts, List<Measure> measures)
            throws IOException, InterruptedException {
        Path settings = Files.createTempDirectory("cold");
        double time = milliseconds(
                starts,
                List.of(
                        "-Dtompkins.settings=" + settings,
                        "-cp",
                        JAR + File.pathSeparator + Path.of("target/test-classes"),
                        WINDOW),
                arguments);
        measures.add(Measure.atMost("cold start to the first picture in the window, " + name, 1200, "ms", time));
    }

    private static double milliseconds(int starts, List<String> program, List<String> arguments)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(program);
        command.addAll(arguments);
        double[] times = new double[starts];
        for (int i = 0; i < starts; i++) {
            long start = System.nanoTime();
            int exit = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start()
                    .waitFor();
            times[i] = (System.nanoTime() - start) / 1e6;
            if (exit != 0) {
                throw new IOException("the program ended with exit code " + exit);
            }
        }
        return Measure.median(times);
    }
}
