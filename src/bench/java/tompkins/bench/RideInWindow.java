package tompkins.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** How live rides are in the window: through Fig. 1(b), the scenes with motion, and the first scene of the program. */
final class RideInWindow {

    private static final String BENCHMARK = "tompkins.ui.RideBenchmark";
    private static final Path SCENES = Path.of("scenes");
    private static final String FIRST = SCENES.resolve("town-square.json").toString();

    private RideInWindow() {}

    /**
     * Rides through all of them in one process, and adds the medians of each.
     *
     * @param thrusts how often there is thrust in each scene
     */
    static void measure(int thrusts, List<Measure> measures) throws IOException, InterruptedException {
        if (!Window.isPossible()) {
            measures.add(Measure.missing(Measure.Kind.NOTICED, "rides", Window.NO_DISPLAY));
            return;
        }
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                BENCHMARK,
                Integer.toString(thrusts),
                SCENES.resolve("fig1b.json").toString()));
        try (Stream<Path> files = Files.list(SCENES)) {
            files.filter(file -> file.getFileName().toString().startsWith("motion-"))
                    .sorted()
                    .forEach(file -> command.add(file.toString()));
        }
        command.addAll(List.of(FIRST, "beside-rest", FIRST));
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (BufferedReader lines = process.inputReader()) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                add(line, measures);
            }
        }
        if (process.waitFor() != 0) {
            throw new IOException("the window ended with exit code " + process.exitValue());
        }
    }

    private static void add(String line, List<Measure> measures) {
        int colon = line.indexOf(": ");
        String ride = "ride, 826 x 620, " + line.substring(0, colon);
        String[] values = line.substring(colon + 2).split(" ");
        measures.add(Measure.noticedAtLeast(ride + ": pictures in a second", 30, "", Double.parseDouble(values[0])));
        measures.add(Measure.noticedAtMost(
                ride + ": thrust to a picture on the screen", 50, "ms", Double.parseDouble(values[1])));
        String difference = ride + ": difference to the whole picture, with " + values[2] + " samples of a pixel";
        measures.add(Measure.noticedAtMost(difference, 4, "levels", Double.parseDouble(values[3])));
        measures.add(Measure.noticedAtMost(
                ride + ": difference in the worst second", 8, "levels", Double.parseDouble(values[4])));
    }
}
