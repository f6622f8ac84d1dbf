package tompkins.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import tompkins.render.RenderReport;
import tompkins.render.Renderer;
import tompkins.trace.RenderPlan;

/**
 * Measures a scene in a process of its own: what the compiler learns from one decides for the next, up to a third of
 * its time.
 */
final class OwnProcess {

    private static final int FEWEST_PICTURES = 10;

    private OwnProcess() {}

    /** The numbers that the {@code main} method of a class prints in a process of its own. */
    static double[] numbers(Class<?> program, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                // a heap that just holds a million objects would be marked beside every few pictures
                "-Xms3g",
                "-Xmx6g",
                "-cp",
                System.getProperty("java.class.path"),
                program.getName()));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.US_ASCII).strip();
        if (process.waitFor() != 0) {
            throw new IOException(program.getSimpleName() + " failed with " + String.join(" ", arguments));
        }
        return Arrays.stream(output.split(" ")).mapToDouble(Double::parseDouble).toArray();
    }

    /**
     * The median of the second half of the pictures: the compiler has settled then.
     *
     * @param seconds how long to take pictures at least
     */
    static double nanosecondsPerRay(RenderPlan plan, double seconds) throws InterruptedException {
        List<Double> nanoseconds = new ArrayList<>();
        try (Renderer renderer = new Renderer()) {
            long start = System.nanoTime();
            while (nanoseconds.size() < FEWEST_PICTURES || System.nanoTime() - start < seconds * 1e9) {
                RenderReport report = renderer.render(plan).report();
                nanoseconds.add(report.time().toNanos() / (double) (report.counts().rays + report.counts().shadowRays));
            }
        }
        return nanoseconds.stream()
                .skip(nanoseconds.size() / 2)
                .sorted()
                .skip(nanoseconds.size() / 4)
                .findFirst()
                .orElseThrow();
    }
}
