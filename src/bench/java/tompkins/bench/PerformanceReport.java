package tompkins.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.openjdk.jmh.runner.RunnerException;

/**
 * Measures what the program takes, prints the table of targets, and writes {@code docs/performance.md}. What is not
 * measured in full, or not all, is written to {@code target/performance.md} instead.
 */
final class PerformanceReport {

    private static final Path PAGE = Path.of("docs/performance.md");

    /** The heading of the part of the page that is written by hand and stays. */
    private static final String BY_HAND = "\n## What makes it fast\n";

    private static final String HEAD = """
            which writes this page down to [What makes it fast](#what-makes-it-fast). All numbers are medians of one run, in which what is compared
            takes turns. A warm picture takes over the prepared scene, as in the window, where only the camera changes. Other ways to measure
            stand in [Contributing](contributing.md#benchmarks).
            """;

    private static final String RATIOS = """
            Ratios of times of this run, and counts. They depend little on how fast the machine is, though one processor favours other programs than
            another does: POV-Ray is slower on AMD's, so that the targets are 8 and 13 there, 5 and 7 elsewhere.

            | measure | target | measured | met |
            | --- | --- | --- | --- |
            """;

    private static final String NOTICED = """
            The limits are those of people: what is faster is not seen. A slow machine may miss them. The window needs a display.

            | measure | target | measured | met here |
            | --- | --- | --- | --- |
            """;

    private static final String TIMES = """
            They tell what to expect on a machine like the one above, and have no targets.

            | measure | here |
            | --- | --- |
            """;

    private static final String PACKETS = """

            [What makes it fast](#what-makes-it-fast) tells what each part of the program gains.

            Native packets are faster because they do all the work for sixteen rays in one instruction, in single precision. Here the rays
            of a block lie in arrays of numbers, too, and the loops that make them and that tell them from the candidates are short enough for
            Java's compiler to take several rays at once; what then hits is tested and shaded ray by ray, in double precision. To come
            closer, hits, shading and shadows would have to be worked out for many rays at once with the Vector API, which Java 17 and
            25 have as an incubator only; doubles would gain half of what floats gain, and floats lose the digits that this program is
            about.
            """;

    private final boolean quick;
    private final Path before;
    private final Set<Part> parts;
    private final List<Measure> measures = new ArrayList<>();
    private final StringBuilder details = new StringBuilder();

    private PerformanceReport(boolean quick, Set<Part> parts, Path before) {
        this.quick = quick;
        this.parts = parts;
        this.before = before;
    }

    /**
     * Measures.
     *
     * @param arguments {@code full}, or {@code quick} to see in a few minutes that all works; and the names of the
     *     {@linkplain Part#named parts}; and a jar of the program to compare with
     */
    public static void main(String[] arguments) throws IOException, InterruptedException, RunnerException {
        PerformanceReport report =
                new PerformanceReport(arguments[0].equals("quick"), Part.named(arguments[1]), Path.of(arguments[2]));
        for (Part part : report.parts) {
            report.measure(part);
        }
        report.write();
    }

    private void measure(Part part) throws IOException, InterruptedException, RunnerException {
        switch (part) {
            case FIGURES ->
                details.append(Figures.measure(quick ? 6 : 16, processor().contains("AMD"), measures))
                        .append(PACKETS);
            case DRAG -> Drag.measure(quick ? 3 : 30, measures);
            case LENS ->
                (quick ? new Convergence(160, 200, 4096) : new Convergence(640, 4000, 16384)).measure(measures);
            case GROWTH -> details.append(Growth.measure(quick ? 1 : 3, measures));
            case MOTION -> MotionCost.measure(quick ? 1 : 5, measures);
            case START -> ColdStart.measure(quick ? 1 : 7, measures);
            case BEFORE -> compare();
            case WINDOW -> Window.measure(quick ? 1 : 3, measures);
            case RIDE -> details.append(RideInWindow.measure(quick ? 3 : 10));
            case LARGE -> LargePicture.measure(quick ? 2000 : 5000, measures);
            case SCENES -> details.append(Scenes.measure(quick ? 2 : 8));
            case METHODS -> details.append(HotMethods.measure(quick ? 50 : 500));
        }
    }

    private void compare() throws InterruptedException {
        String why = "there is no " + before + " (-Dtompkins.bench.before=JAR names it)";
        if (Files.exists(before)) {
            try {
                ColdStart.compare(before, quick ? 1 : 7, measures);
                return;
            } catch (IOException failure) {
                // what the other parts have measured is kept
                why = failure.getMessage();
            }
        }
        measures.add(Measure.missing(Measure.Kind.RATIO, "against an earlier jar", why));
    }

    private void write() throws IOException {
        StringBuilder text = new StringBuilder("# Performance\n\nMeasured on " + LocalDate.now(ZoneOffset.UTC) + ", "
                        + processor() + ", " + Runtime.getRuntime().availableProcessors() + " cores, Java "
                        + System.getProperty("java.version")
                        + ", by\n\n    xvfb-run -a mvn -Pbench -DskipTests verify\n\n")
                .append(HEAD);
        section(text, "Ratios", RATIOS, Measure.Kind.RATIO);
        section(text, "What people notice", NOTICED, Measure.Kind.NOTICED);
        section(text, "Times", TIMES, Measure.Kind.TIME);
        text.append(details);
        String page = Files.readString(PAGE);
        text.append(page.substring(page.indexOf(BY_HAND)));
        System.out.println(text);
        boolean whole = !quick && parts.equals(EnumSet.allOf(Part.class));
        Files.writeString(whole ? PAGE : Path.of("target/performance.md"), text);
    }

    private void section(StringBuilder text, String title, String head, Measure.Kind kind) {
        text.append("\n## ").append(title).append("\n\n").append(head);
        measures.stream().filter(measure -> measure.kind() == kind).forEach(measure -> text.append(measure.line()));
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
