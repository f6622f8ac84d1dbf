package tompkins.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import tompkins.ui.WindowBenchmark;

/** What the window takes with Fig. 1(b), each time with a fresh process. */
final class Window {

    /** Why nothing can be measured. */
    static final String NO_DISPLAY = "there is no display (xvfb-run -a mvn ...)";

    private Window() {}

    /** Whether there is a display. */
    static boolean isPossible() {
        return System.getenv("DISPLAY") != null;
    }

    /** Opens the window some times, and adds the medians of what was measured in it. */
    static void measure(int times, List<Measure> measures) throws IOException, InterruptedException {
        if (!isPossible()) {
            measures.add(Measure.missing("window, fig1b", NO_DISPLAY));
            return;
        }
        Map<String, List<Double>> values = new TreeMap<>();
        for (int i = 0; i < times; i++) {
            open(values);
        }
        measures.add(Measure.noticedAtMost(
                "window, fig1b: change of the speed to a picture on the screen",
                50,
                "ms",
                median(values, "change to picture on screen")));
        measures.add(Measure.noticedAtMost(
                "window, fig1b: change of the speed to the complete picture",
                300,
                "ms",
                median(values, "change to complete picture")));
        measures.add(Measure.noticedAtLeast(
                "window, fig1b: pictures in a second while the speed is dragged",
                30,
                "",
                median(values, "pictures in a second while dragging")));
    }

    private static void open(Map<String, List<Double>> values) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        WindowBenchmark.class.getName(),
                        "scenes/fig1b.json")
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (BufferedReader lines = process.inputReader()) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                int colon = line.indexOf(": ");
                values.computeIfAbsent(line.substring(0, colon), name -> new ArrayList<>())
                        .add(Double.valueOf(line.substring(colon + 2)));
            }
        }
        if (process.waitFor() != 0) {
            throw new IOException("the window ended with exit code " + process.exitValue());
        }
    }

    private static double median(Map<String, List<Double>> values, String name) {
        return Measure.median(values.get(name));
    }
}
