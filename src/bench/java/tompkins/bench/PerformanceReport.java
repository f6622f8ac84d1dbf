package tompkins.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Named;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import tompkins.render.RenderReport;
import tompkins.studio.PaperStudios;
import tompkins.studio.SceneFiles;
import tompkins.studio.Studio;

/**
 * Measures everything, prints the table of targets, and writes {@code docs/performance.md}. With the argument
 * {@code quick} it takes a minute or two to see that all works, and writes to {@code target/performance.md} instead.
 */
final class PerformanceReport {

    /** Pictures of one kind that follow each other in a round. */
    private static final int PICTURES_IN_TURN = 5;

    /** Slow scenes get fewer rounds. */
    private static final long LONGEST_SCENE_NANOSECONDS = 5_000_000_000L;

    private static final String PACKETS = """

            [Speed-ups](speed-ups.md) tells what the program does to be fast, and what each part gains.

            Native packets are faster because they do all the work for sixteen rays in one instruction, in single precision. Here the rays
            of a block lie in arrays of numbers, too, and the loops that make them and that tell them from the candidates are short enough for
            Java's compiler to take several rays at once; what then hits is tested and shaded ray by ray, in double precision. To come
            closer, hits, shading and shadows would have to be worked out for many rays at once with the Vector API, which Java 17 and
            25 have as an incubator only; doubles would gain half of what floats gain, and floats lose the digits that this program is
            about.
            """;

    private static final int LARGE_WIDTH = 1280;
    private static final int LARGE_HEIGHT = 960;

    private final boolean quick;
    private final List<Measure> measures = new ArrayList<>();
    private final StringBuilder machine = new StringBuilder(Yardstick.HEAD);
    private final StringBuilder details = new StringBuilder();

    private PerformanceReport(boolean quick) {
        this.quick = quick;
    }

    /** Measures; the argument is {@code quick} or {@code full}. */
    public static void main(String[] arguments) throws IOException, InterruptedException, RunnerException {
        PerformanceReport report = new PerformanceReport(arguments[0].equals("quick"));
        report.figures();
        Drag.measure(report.quick ? 3 : 60, report.measures);
        report.lens();
        report.growth();
        MotionCost.measure(report.quick ? 1 : 5, report.measures);
        report.processes();
        report.scenes();
        report.hotMethods();
        report.write();
    }

    /**
     * The paper's two figures, alternating with one thread, two threads and POV-Ray. POV-Ray is compared at four times
     * the size: at 640 x 480 a good part of its time is the start of its threads.
     */
    private void figures() throws InterruptedException {
        int rounds = quick ? 10 : 40;
        double[] povRest = new double[rounds];
        double[] povMoving = new double[rounds];
        double[] povRestSmall = new double[rounds];
        double[] povMovingSmall = new double[rounds];
        try (Picture rest = new Picture(PaperStudios.fig1a(), 2);
                Picture restLarge = new Picture(large(PaperStudios.fig1a()), 2);
                Picture movingLarge = new Picture(large(PaperStudios.fig1b()), 2);
                Picture restAlone = new Picture(PaperStudios.fig1a(), 1);
                Picture moving = new Picture(PaperStudios.fig1b(), 2);
                Picture movingAlone = new Picture(PaperStudios.fig1b(), 1)) {
            List<Picture> pictures = List.of(rest, moving, restAlone, movingAlone);
            for (int round = 0; round < rounds; round++) {
                for (Picture picture : pictures) {
                    picture.take(PICTURES_IN_TURN);
                }
                povRestSmall[round] = PovRay.milliseconds(false, 640, 480);
                povMovingSmall[round] = PovRay.milliseconds(true, 640, 480);
                restLarge.take(1);
                povRest[round] = PovRay.milliseconds(false, LARGE_WIDTH, LARGE_HEIGHT);
                movingLarge.take(1);
                povMoving[round] = PovRay.milliseconds(true, LARGE_WIDTH, LARGE_HEIGHT);
            }
            against(rest.median(), 30, 130, Yardstick.REST);
            againstPovRay(restLarge.median(), "fig1a", povRest);
            against(moving.median(), 15, 140, Yardstick.MOVING);
            againstPovRay(movingLarge.median(), "fig1b", povMoving);
            machine.append(Yardstick.REST.line(rest.median(), povRestSmall));
            machine.append(Yardstick.MOVING.line(moving.median(), povMovingSmall));
            measures.add(
                    Measure.atLeast("fig1a, two threads against one", 1.85, "x", restAlone.median() / rest.median()));
            measures.add(Measure.atMost("fig1b: allocation per sample", 1000, "bytes", moving.bytesPerSample()));
        }
    }

    private void against(double time, double most, double drTimFactor, Yardstick elsewhere) {
        String name = elsewhere.figure();
        measures.add(Measure.atMost(name + ", 640 x 480, one sample, 2 threads", most, "ms", time));
        measures.add(Measure.atLeast(
                name + " against Dr TIM, " + Measure.number(elsewhere.drTim()) + " ms",
                drTimFactor,
                "x",
                elsewhere.drTim() / time));
        measures.add(Measure.atMost(name + " against a native scalar tree tracer", elsewhere.tree(), "ms", time));
        measures.add(Measure.atMost(name + " against Embree, single rays", elsewhere.embree(), "ms", time));
        measures.add(Measure.atMost(
                name + " against native 16-wide packets, " + elsewhere.packets() + " ms",
                6,
                "x",
                time / elsewhere.packets()));
    }

    private void againstPovRay(double time, String name, double[] povRay) {
        double pov = Measure.median(povRay);
        String what = name + ", " + LARGE_WIDTH + " x " + LARGE_HEIGHT + ", against POV-Ray 3.7 in this run";
        measures.add(
                Double.isNaN(pov)
                        ? Measure.missing(what, "POV-Ray is not installed (apt-get install povray)")
                        : Measure.atLeast(what + ", " + Measure.number(pov) + " ms", 5, "x", pov / time));
    }

    private static Studio large(Studio studio) {
        return studio.withSettings(studio.settings().withSize(LARGE_WIDTH, LARGE_HEIGHT));
    }

    private void lens() throws InterruptedException {
        Convergence convergence = quick ? new Convergence(160, 200, 4096) : new Convergence(640, 4000, 16384);
        measures.add(convergence.measure());
    }

    private void growth() throws IOException, InterruptedException {
        Growth growth = new Growth(quick ? 1 : 3);
        growth.measure(measures);
        details.append(
                "\n## Growth\n\nTime of a whole 640 x 480 picture with shadows on two threads, per ray; spheres and rods get thinner"
                        + " where there are more. Each in a\nprocess of its own, whose heap begins with 3 GB: one that just holds a million objects would be marked by the"
                        + " collector beside\nevery few pictures.\n\n");
        details.append(growth.table());
    }

    private void processes() throws IOException, InterruptedException {
        starts();
        Window.measure(quick ? 1 : 3, measures);
        RideInWindow.measure(measures);
        LargePicture.measure(quick ? 2000 : 20_000, measures);
    }

    private void starts() throws IOException, InterruptedException {
        if (!ColdStart.isPossible()) {
            measures.add(Measure.missing("cold start", "there is no target/tompkins.jar"));
            return;
        }
        measures.add(
                Measure.atMost("cold start to a 640 x 480 file, fig1b", 900, "ms", ColdStart.toFile(quick ? 3 : 21)));
        measures.add(
                Window.isPossible()
                        ? Measure.atMost(
                                "cold start to the first picture in the window, fig1b",
                                1200,
                                "ms",
                                ColdStart.toWindow(quick ? 3 : 21))
                        : Measure.missing("cold start to the window", Window.NO_DISPLAY));
    }

    /** All scenes, one after the other with one and two threads, round by round. */
    private void scenes() throws InterruptedException {
        int rounds = quick ? 2 : 12;
        details.append("\n## Scenes\n\nAs they are, warm; millions of rays per second with 1 and 2 threads.\n\n"
                + "| scene | ms, 2 threads | rays, 1 | rays, 2 | shadow rays, 1 | shadow rays, 2 | bytes per ray | nodes per ray | tests per ray |\n"
                + "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
        for (Named<Studio> scene : SceneFiles.all().toList()) {
            try (Picture alone = new Picture(scene.getPayload(), 1);
                    Picture both = new Picture(scene.getPayload(), 2)) {
                long start = System.nanoTime();
                for (int round = 0;
                        round < 2 || round < rounds && System.nanoTime() - start < LONGEST_SCENE_NANOSECONDS;
                        round++) {
                    alone.take(1);
                    both.take(1);
                }
                details.append(row(scene.getName(), alone.median(), both));
            }
        }
    }

    private static String row(String name, double alone, Picture both) {
        RenderReport report = both.report();
        double rays = report.rays() + report.shadowRays();
        return String.format(
                Locale.ROOT,
                "| %s | %.1f | %.2f | %.2f | %.2f | %.2f | %.0f | %.2f | %.2f |%n",
                name,
                both.median(),
                report.rays() / alone / 1000,
                report.rays() / both.median() / 1000,
                report.shadowRays() / alone / 1000,
                report.shadowRays() / both.median() / 1000,
                both.bytesPerSample() * report.samples() / rays,
                report.nodes() / rays,
                report.tests() / rays);
    }

    private void hotMethods() throws RunnerException, IOException {
        Files.createDirectories(Path.of("target"));
        OptionsBuilder options = new OptionsBuilder();
        options.include(HotMethodsBenchmark.class.getName())
                .resultFormat(ResultFormatType.JSON)
                .result("target/jmh.json");
        if (quick) {
            options.warmupIterations(1)
                    .measurementIterations(1)
                    .measurementTime(TimeValue.milliseconds(200))
                    .warmupTime(TimeValue.milliseconds(200));
        }
        Collection<RunResult> results = new Runner(options.build()).run();
        details.append("\n## Hot methods\n\n| method | ns | error |\n| --- | --- | --- |\n");
        for (RunResult result : results) {
            String shape = result.getParams().getParam("shape");
            Result<?> time = result.getPrimaryResult();
            details.append(String.format(
                    Locale.ROOT,
                    "| %s%s | %.1f | %.1f |%n",
                    time.getLabel(),
                    shape == null ? "" : ", " + shape,
                    time.getScore(),
                    time.getScoreError()));
        }
    }

    private void write() throws IOException {
        StringBuilder text = new StringBuilder("# Performance\n\nMeasured on " + LocalDate.now(ZoneOffset.UTC) + ", "
                + processor() + ", " + Runtime.getRuntime().availableProcessors() + " cores, Java "
                + System.getProperty("java.version") + ", by\n\n    xvfb-run -a mvn -Pbench -DskipTests verify\n\n"
                + "which writes this file. All times are medians of one run in which everything takes turns; `-Dbench.mode=quick`"
                + " tries the same in a few minutes\nand writes to `target/performance.md`. The figures of the window need a display,"
                + " those of POV-Ray that it is installed.\nDr TIM, the native tracers and Embree were"
                + " measured elsewhere with the same scene (see Machine); POV-Ray runs in turns with the program.\nA warm picture"
                + " takes over the prepared scene, as in the window, where only the camera changes.\n\n"
                + "| measure | target | measured | met |\n| --- | --- | --- | --- |\n");
        measures.forEach(measure -> text.append(measure.line()));
        text.append(machine);
        text.append(PACKETS);
        text.append(details);
        System.out.println(text);
        Files.writeString(Path.of(quick ? "target/performance.md" : "docs/performance.md"), text);
    }

    private static String processor() throws IOException {
        Path file = Path.of("/proc/cpuinfo");
        return !Files.exists(file)
                ? System.getProperty("os.arch")
                : Files.readAllLines(file).stream()
                        .filter(line -> line.startsWith("model name"))
                        .map(line -> line.replaceAll(".*:\\s*", ""))
                        .findFirst()
                        .orElse(System.getProperty("os.arch"));
    }
}
