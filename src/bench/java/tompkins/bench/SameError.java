package tompkins.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.study.Chart;
import tompkins.study.ChartDrawing;
import tompkins.study.Spread;
import tompkins.study.StudyPoint;

/**
 * What whole commands of the program and of POV-Ray take to the same error, each with the cheapest setting that reaches
 * it. Each setting is tried once; those that are the cheapest for an error then take turns. The reference of each
 * program is its own picture with many samples.
 */
final class SameError {

    /** The chart of error against time, beside the page. */
    static final String CHART = "error-against-seconds.png";

    private static final List<String> FIGURES = List.of("fig1a", "fig1b", "fig2a", "fig3a");

    private static final List<Double> ERRORS = List.of(0.02, 0.01, 0.005);

    private static final Path PICTURE = Path.of("target/same-error.png");
    private static final Pattern RENDERING = Pattern.compile("\\(([0-9.]+) s, ");

    /** The numbers of samples of each pixel that are tried. */
    private static final List<Integer> SAMPLES = List.of(1, 2, 4, 8, 16);

    /** The values of {@code --error} that are tried. */
    private static final List<Double> WANTED = List.of(0.03, 0.02, 0.014, 0.01, 0.007, 0.005, 0.0035);

    private static final String REFERENCE_SEED = "99";

    /** A setting, what it cost at the first time, and how wrong the picture was. */
    private record Trial(PictureCommand command, double processor, double error) {}

    private final int width;
    private final int samplesOfReference;
    private final String version;
    private final Map<String, List<Trial>> own = new LinkedHashMap<>();
    private final Map<String, List<Trial>> others = new LinkedHashMap<>();
    private final Map<PictureCommand, List<PictureCommand.Cost>> costs = new LinkedHashMap<>();

    private SameError(int width, int samplesOfReference) throws InterruptedException {
        this.width = width;
        this.samplesOfReference = samplesOfReference;
        version = PovRay.version();
    }

    /**
     * Measures, and draws the chart.
     *
     * @param width of the pictures
     * @param samplesOfReference in each pixel of the program's reference
     * @param turns how often each of the cheapest settings is measured
     */
    static SameError measure(int width, int samplesOfReference, int turns, Path folder)
            throws IOException, InterruptedException {
        SameError same = new SameError(width, samplesOfReference);
        for (String figure : FIGURES) {
            same.tryAll(figure);
        }
        same.takeTurns(turns);
        same.draw(folder);
        return same;
    }

    private void tryAll(String figure) throws IOException, InterruptedException {
        PictureCommand reference =
                own(figure, "", "--samples", Integer.toString(samplesOfReference), "--seed", REFERENCE_SEED);
        List<PictureCommand> settings = Stream.concat(
                        SAMPLES.stream().map(samples -> own(figure, "samples", samples)),
                        WANTED.stream().map(error -> own(figure, "error", error)))
                .toList();
        own.put(figure, trials(reference, settings));
        if (version != null && PovRay.OPTIONS.containsKey(figure)) {
            PovRay other = new PovRay(figure, width);
            others.put(figure, trials(other.reference(), other.settings()));
        } else {
            others.put(figure, List.of());
        }
    }

    private PictureCommand own(String figure, String option, Number value) {
        return own(figure, option + " " + value, "--" + option, value.toString());
    }

    private PictureCommand own(String figure, String setting, String... options) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-jar",
                "target/tompkins.jar",
                "render",
                "scenes/" + figure + ".json",
                "--size",
                width + "x" + width * 3 / 4,
                "--threads",
                "2",
                "--format",
                "png16",
                "--force",
                "-o",
                PICTURE.toString()));
        command.addAll(List.of(options));
        return new PictureCommand(setting, command, RENDERING, PICTURE, 1, 1);
    }

    private static List<Trial> trials(PictureCommand reference, List<PictureCommand> settings)
            throws IOException, InterruptedException {
        System.out.println("reference: " + reference.run());
        double[] exact = reference.light();
        List<Trial> trials = new ArrayList<>();
        for (PictureCommand setting : settings) {
            PictureCommand.Cost cost = setting.run();
            double error = rootMeanSquare(setting.light(), exact);
            System.out.printf(Locale.ROOT, "%s: error %.5f, %s%n", setting.setting(), error, cost);
            trials.add(new Trial(setting, cost.processor(), error));
        }
        trials.sort(Comparator.comparingDouble(Trial::processor));
        return trials;
    }

    private static double rootMeanSquare(double[] one, double[] other) {
        double squares = 0;
        for (int i = 0; i < one.length; i++) {
            squares += (one[i] - other[i]) * (one[i] - other[i]);
        }
        return Math.sqrt(squares / one.length);
    }

    /** The setting that reached an error with the least time of the processor, if any did. */
    private static Optional<PictureCommand> cheapest(List<Trial> trials, double error) {
        return trials.stream()
                .filter(trial -> trial.error() <= error)
                .findFirst()
                .map(Trial::command);
    }

    private void takeTurns(int turns) throws IOException, InterruptedException {
        for (String figure : FIGURES) {
            for (double error : ERRORS) {
                Stream.of(own, others)
                        .flatMap(program -> cheapest(program.get(figure), error).stream())
                        .forEach(command -> costs.put(command, new ArrayList<>()));
            }
        }
        for (int turn = 0; turn < turns; turn++) {
            for (Map.Entry<PictureCommand, List<PictureCommand.Cost>> each : costs.entrySet()) {
                PictureCommand.Cost cost = each.getKey().run();
                System.out.println(each.getKey().setting() + ": " + cost);
                each.getValue().add(cost);
            }
        }
    }

    private void draw(Path folder) throws IOException {
        String method = "Tompkins, cheapest setting";
        List<StudyPoint> points = new ArrayList<>(points(method, own.get("fig1a")));
        points.addAll(points("POV-Ray " + version + ", cheapest setting", others.get("fig1a")));
        Chart chart = new Chart(
                "fig1a",
                "Fig. 1(a), " + width + " x " + width * 3 / 4 + ", whole commands",
                new Chart.Axis("seconds of the processor", StudyPoint::seconds),
                new Chart.Axis("true RMS error in linear light (white = 1)", StudyPoint::error),
                true,
                method);
        Files.createDirectories(folder);
        Files.write(folder.resolve(CHART), ChartDrawing.png(chart, points));
    }

    /** The trials that are better than all cheaper ones. */
    private static List<StudyPoint> points(String method, List<Trial> trials) {
        List<StudyPoint> points = new ArrayList<>();
        double best = Double.POSITIVE_INFINITY;
        for (Trial trial : trials) {
            if (trial.error() < best) {
                best = trial.error();
                points.add(point(method, trial));
            }
        }
        return points;
    }

    private static StudyPoint point(String method, Trial trial) {
        // points are joined from large errors to small ones, in the place of few rays to many
        double order = 1 / trial.error();
        return new StudyPoint(
                "fig1a",
                method,
                0,
                order,
                Spread.exact(trial.processor()),
                Spread.exact(trial.error()),
                trial.error(),
                0);
    }

    /** What the page says first about POV-Ray. */
    String sentence() {
        return version == null
                ? "- " + PovRay.MISSING + ".\n"
                : "- To an error of 0.005 POV-Ray takes " + ratio(0.005)
                        + " times the processor time of Tompkins in Fig. 1(a), to 0.02 " + ratio(0.02) + " times.\n";
    }

    /** How many times the processor time of the program POV-Ray takes for Fig. 1(a) to an error. */
    private String ratio(double error) {
        Optional<PictureCommand> other = cheapest(others.get("fig1a"), error);
        Optional<PictureCommand> program = cheapest(own.get("fig1a"), error);
        return other.isPresent() && program.isPresent()
                ? Measure.number(median(other.get(), PictureCommand.Cost::processor)
                        / median(program.get(), PictureCommand.Cost::processor))
                : "(not measured)";
    }

    private double median(PictureCommand command, ToDoubleFunction<PictureCommand.Cost> seconds) {
        return Measure.median(costs.get(command).stream().mapToDouble(seconds).toArray());
    }

    /** The section of the page. */
    String section() {
        StringBuilder text = new StringBuilder("""

                ## To the same error

                Seconds of whole commands, cold, %d x %d, two threads: processor, wall, rendering alone; in brackets the cheapest setting tried that
                reached the error. Errors are root mean squares in linear light, to each program's own picture with many samples.
                POV-Ray transforms nothing: as a stand-in for Fig. 1(b) it sees the scene at rest along a mesh of aberrated directions.
                For Fig. 2(a) and 3(a) it has nothing.

                | seconds | 0.02 | 0.01 | 0.005 |
                | --- | --- | --- | --- |
                """.formatted(width, width * 3 / 4));
        for (String figure : FIGURES) {
            text.append(row(figure, own.get(figure)));
            if (!others.get(figure).isEmpty()) {
                text.append(row(figure + ", POV-Ray", others.get(figure)));
            }
        }
        return text.toString();
    }

    private String row(String name, List<Trial> trials) {
        return ERRORS.stream()
                .map(error -> cheapest(trials, error).map(this::cell).orElse("not reached"))
                .collect(Collectors.joining(" | ", "| " + name + " | ", " |\n"));
    }

    private String cell(PictureCommand command) {
        return Measure.number(median(command, PictureCommand.Cost::processor)) + ", "
                + Measure.number(median(command, PictureCommand.Cost::wall)) + ", "
                + Measure.number(median(command, PictureCommand.Cost::rendering)) + " (" + command.setting() + ")";
    }
}
