package tompkins.bench;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** How long the program takes with a fresh process, from the start of Java on, to what it was started for. */
final class ColdStart {

    private static final Path JAR = Path.of("target/tompkins.jar");
    private static final String WINDOW = "tompkins.ui.StartBenchmark";

    private ColdStart() {}

    /** Whether there is a program to start. */
    static boolean isPossible() {
        return Files.exists(JAR);
    }

    /** The median time of some starts to the end of a photograph that was saved, in milliseconds. */
    static double toFile(int starts) throws IOException, InterruptedException {
        Path picture = Files.createTempFile("cold", ".png");
        double time = milliseconds(
                starts,
                List.of(
                        "-jar",
                        JAR.toString(),
                        "render",
                        "scenes/fig1b.json",
                        "--samples",
                        "1",
                        "--force",
                        "-o",
                        picture.toString()));
        Files.delete(picture);
        return time;
    }

    /** The median time of some starts to the first picture in its window, in milliseconds. Needs a display. */
    static double toWindow(int starts) throws IOException, InterruptedException {
        Path settings = Files.createTempDirectory("cold");
        return milliseconds(
                starts,
                List.of(
                        "-Dtompkins.settings=" + settings,
                        "-cp",
                        JAR + File.pathSeparator + Path.of("target/test-classes"),
                        WINDOW));
    }

    private static double milliseconds(int starts, List<String> arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(arguments);
        command.add(0, Path.of(System.getProperty("java.home"), "bin", "java").toString());
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
        Arrays.sort(times);
        return times[starts / 2];
    }
}
