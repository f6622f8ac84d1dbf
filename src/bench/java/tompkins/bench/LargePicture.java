package tompkins.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.Renderer;
import tompkins.studio.PaperStudios;
import tompkins.trace.RenderPlan;

/**
 * Begins Fig. 3(a) with 3840 x 2160 pixels and 64 samples in a process of its own, cancels it after a while and saves
 * what is there. Memory does not depend on how far the picture is: film, image and file are there from the first
 * sample.
 */
final class LargePicture {

    private LargePicture() {}

    /** Measures in this process, and prints three numbers. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        long start = System.nanoTime();
        CountDownLatch begun = new CountDownLatch(1);
        RenderListener listener = new RenderListener() {
            @Override
            public void tileDone(RenderJob job) {
                begun.countDown();
            }
        };
        try (Renderer renderer = new Renderer()) {
            RenderPlan plan = RenderPlan.of(PaperStudios.fig3a()
                    .withSettings(
                            PaperStudios.fig3a().settings().withSize(3840, 2160).withSamples(64)));
            RenderJob job = renderer.start(plan, Quality.of(plan.studio()), listener);
            begun.await();
            double progress = (System.nanoTime() - start) / 1e6;
            Thread.sleep(Long.parseLong(arguments[0]));
            long cancel = System.nanoTime();
            job.cancel();
            job.await();
            double end = (System.nanoTime() - cancel) / 1e6;
            Path file = Files.createTempFile("large", ".png");
            PhotographFile.write(
                    file,
                    job.image(),
                    PictureFormat.PNG,
                    ToneCurve.LINEAR,
                    new PhotographInfo("large", "bench", "{}"),
                    true);
            Files.delete(file);
            System.out.println(progress + " " + end + " " + peakMegabytes());
        }
    }

    private static double peakMegabytes() throws IOException {
        return Files.readAllLines(Path.of("/proc/self/status")).stream()
                .filter(line -> line.startsWith("VmHWM"))
                .mapToDouble(line -> Double.parseDouble(line.replaceAll("\\D", "")) / 1024)
                .findFirst()
                .orElse(Double.NaN);
    }

    /** Measures in a new process that renders for some milliseconds. */
    static void measure(long milliseconds, List<Measure> measures) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx288m",
                        "-cp",
                        System.getProperty("java.class.path"),
                        LargePicture.class.getName(),
                        Long.toString(milliseconds))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        String[] numbers = new String(process.getInputStream().readAllBytes(), StandardCharsets.US_ASCII)
                .strip()
                .split(" ");
        if (process.waitFor() != 0) {
            measures.add(Measure.missing("3840 x 2160, 64 samples, fig3a", "the process failed"));
            return;
        }
        String what = "3840 x 2160, 64 samples, fig3a: ";
        measures.add(Measure.noticedAtMost(what + "first progress, cold", 1000, "ms", Double.parseDouble(numbers[0])));
        measures.add(Measure.noticedAtMost(what + "cancelled within", 100, "ms", Double.parseDouble(numbers[1])));
        measures.add(Measure.noticedAtMost(
                what + "memory of the process with a heap of 288 MB, picture saved",
                400,
                "MB",
                Double.parseDouble(numbers[2])));
    }
}
