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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tompkins.io.SelfDescription;

/**
 * Measures what the program takes, prints it, and writes {@code docs/performance.md}. What is not measured in full, or
 * not all, is written to {@code target} instead.
 */
final class PerformanceReport {

    private static final Path PAGE = Path.of("docs/performance.md");

    /** The heading of the part of the page that is written by hand and stays. */
    private static final String BY_HAND = "\n## What makes it fast\n";

    /** What people get, where what was measured stands in braces. */
    private static final String SENTENCES = """
            - A picture of 640 x 480 takes {fig1b, 640 x 480, one sample, two threads} in Fig. 1(b) and {fig1a, 640 x 480, one sample, two threads} in
              Fig. 1(a), with one sample for each pixel and two threads.
            - When the speed changes, the window shows a first picture after {window, fig1b: change of the speed to a picture on the screen} and the whole one
              after {window, fig1b: change of the speed to the complete picture}.
            - From the start of Java to the file of the town square it takes {cold start to a 640 x 480 file, town square}, to its first picture in the
              window {cold start to the first picture in the window, town square}.
            - A ray among a million spheres takes {spheres: time per ray at 1e6 to that at 1e2} the time of one among a hundred.
            """;

    private static final String NOTICED = """

            ## What people notice

            The limits are those of people: what is faster is not seen.

            | measure | measured | target | met here |
            | --- | --- | --- | --- |
            """;

    private static final String OTHERS = """

            ## Times and ratios

            What is compared takes turns.

            | measure | here |
            | --- | --- |
            """;

    private final boolean quick;
    private final Path before;
    private final Set<Part> parts;
    private final List<Measure> measures = new ArrayList<>();
    private final StringBuilder details = new StringBuilder();

    /** The sentence that compares with POV-Ray. */
    private String povRay = "";

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
    public static void main(String[] arguments) throws IOException, InterruptedException {
        PerformanceReport report =
                new PerformanceReport(arguments[0].equals("quick"), Part.named(arguments[1]), Path.of(arguments[2]));
        for (Part part : report.parts) {
            report.measure(part);
        }
        report.write();
    }

    /** Whether all is measured as for the page. */
    private boolean isWhole() {
        return !quick && parts.equals(EnumSet.allOf(Part.class));
    }

    private Path page() {
        return isWhole() ? PAGE : Path.of("target/performance.md");
    }

    private void measure(Part part) throws IOException, InterruptedException {
        switch (part) {
            case FIGURES -> Figures.measure(quick ? 10 : 200, measures);
            case ERROR -> {
                SameError same = SameError.measure(
                        quick ? 160 : 640, quick ? 64 : 512, quick ? 1 : 3, page().resolveSibling("performance"));
                details.append(same.section());
                povRay = same.sentence();
            }
            case DRAG -> Drag.measure(quick ? 3 : 30, measures);
            case LENS ->
                (quick ? new Convergence(160, 200, 4096) : new Convergence(640, 4000, 16384)).measure(measures);
            case SAMPLES ->
                SamplesForError.measure(quick ? 60 : 120, quick ? 1 : 5, page().resolveSibling("performance"));
            case GROWTH -> details.append(Growth.measure(quick ? 1 : 3, measures));
            case MOTION -> MotionCost.measure(quick ? 1 : 5, measures);
            case START -> ColdStart.measure(quick ? 1 : 7, measures);
            case BEFORE -> compare();
            case WINDOW -> Window.measure(quick ? 1 : 3, measures);
            case RIDE -> details.append(RideInWindow.measure(quick ? 3 : 10));
            case LARGE -> LargePicture.measure(quick ? 2000 : 5000, measures);
        }
    }

    /** Compares with another jar, if one is named. */
    private void compare() throws IOException, InterruptedException {
        if (Files.exists(before)) {
            ColdStart.compare(before, quick ? 1 : 7, measures);
        }
    }

    private void write() throws IOException {
        StringBuilder text = new StringBuilder("# Performance\n\n")
                .append(sentences())
                .append("\n![The error of a picture falls with the seconds that it takes](performance/"
                        + SameError.CHART + ")\n\nMeasured on " + LocalDate.now(ZoneOffset.UTC) + " with "
                        + SelfDescription.program() + ", " + processor() + ", "
                        + Runtime.getRuntime().availableProcessors() + " cores, Java "
                        + System.getProperty("java.version")
                        + ", by\n\n    xvfb-run -a mvn -Pbench -DskipTests verify\n\n"
                        + "All numbers are medians of one run. The scene is prepared once, as in the window.\n")
                .append(NOTICED);
        measures.stream().filter(each -> !each.target().isEmpty()).forEach(each -> text.append(each.line()));
        text.append(OTHERS);
        measures.stream()
                .filter(each -> each.target().isEmpty() && !SENTENCES.contains("{" + each.what() + "}"))
                .forEach(each -> text.append(each.line()));
        text.append(details);
        String page = Files.readString(PAGE);
        text.append(page.substring(page.indexOf(BY_HAND)));
        System.out.println(text);
        Files.writeString(page(), text);
    }

    private String sentences() {
        return Pattern.compile("\\{(.+?)}")
                        .matcher(SENTENCES)
                        .replaceAll(found -> Matcher.quoteReplacement(measured(found.group(1))))
                + povRay;
    }

    private String measured(String what) {
        return measures.stream()
                .filter(each -> each.what().equals(what))
                .findFirst()
                .map(each -> each.measured().replace(" x", " times"))
                .orElse("(not measured)");
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
