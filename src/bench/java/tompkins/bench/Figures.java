package tompkins.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.Renderer;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.study.Chart;
import tompkins.study.ChartDrawing;
import tompkins.study.Spread;
import tompkins.study.StudyPoint;
import tompkins.trace.RenderPlan;

/**
 * The paper's two figures: how long they take with one thread and with two, and how the error of Fig. 1(a) falls with
 * the processor time of one thread, beside POV-Ray in the same run. The reference of each program is its own picture
 * with many samples.
 */
final class Figures {

    /** The chart of error against time, beside the page. */
    static final String CHART = "error-against-seconds.png";

    private static final int PICTURES_IN_TURN = 5;
    /** The size of the pictures of the chart. */
    private static final int WIDTH = 320;

    private static final int HEIGHT = 240;
    private static final int TURNS = 3;
    private static final int WARM_UP = 10;
    private static final int REFERENCE_SAMPLES = 512;
    private static final double[] ERRORS = {0.04, 0.02, 0.01, 0.005, 0.0025};
    private static final String OWN = "Tompkins, --error";
    private static final String PROBLEM = "fig1a";

    /** Rows of POV-Ray's grids of samples in a pixel, from this number to the other, above which it knows none. */
    private static final int LEAST_GRID = 2;

    private static final int MOST_GRID = 9;

    /** Differences at which POV-Ray divides a pixel, and how often it does at most. */
    private static final double[] DIFFERENCES = {0.3, 0.1, 0.03, 0.01};

    private static final int LEAST_DEPTH = 3;
    private static final int MOST_DEPTH = 5;

    /** Plain pictures are at most so many times as wide and as high. */
    private static final int MOST_TIMES = 6;

    private static final int TIMES_OF_REFERENCE = 4;

    private Figures() {}

    /** Measures in turns, and draws the chart. */
    static void measure(int rounds, Path folder, List<Measure> measures) throws IOException, InterruptedException {
        addTimes("fig1a", PaperStudios.fig1a(), rounds, measures);
        addTimes("fig1b", PaperStudios.fig1b(), rounds, measures);
        List<StudyPoint> points = new ArrayList<>(own());
        String version = PovRay.version();
        if (version == null) {
            measures.add(Measure.missing("fig1a, --error 0.01, against POV-Ray", PovRay.MISSING));
        } else {
            List<StudyPoint> others = others(version);
            measures.add(Measure.of(
                    "fig1a, as good as with --error 0.01: processor time of POV-Ray " + version
                            + " to that of Tompkins",
                    "x",
                    costTo(0.01, others, point -> point.seconds().middle())
                            / costTo(0.01, points, point -> point.seconds().middle())));
            points.addAll(others);
        }
        Chart chart = Chart.errorAgainstTime(PROBLEM, "Fig. 1(a), " + WIDTH + " x " + HEIGHT + ", one thread", OWN);
        Files.createDirectories(folder);
        Files.write(folder.resolve(CHART), ChartDrawing.png(chart, points));
    }

    private static void addTimes(String name, Studio studio, int rounds, List<Measure> measures)
            throws InterruptedException {
        try (Picture both = new Picture(studio, 2);
                Picture alone = new Picture(studio, 1)) {
            for (int round = 0; round < rounds; round++) {
                both.take(PICTURES_IN_TURN);
                alone.take(PICTURES_IN_TURN);
            }
            measures.add(Measure.of(name + ", 640 x 480, one sample, two threads", "ms", both.median()));
            measures.add(Measure.of(name + ", 640 x 480, one sample, one thread", "ms", alone.median()));
        }
    }

    private static List<StudyPoint> own() throws InterruptedException {
        Studio figure = PaperStudios.fig1a();
        Studio studio = figure.withSettings(figure.settings().withSize(WIDTH, HEIGHT));
        List<StudyPoint> points = new ArrayList<>();
        try (Renderer renderer = new Renderer(1)) {
            RenderPlan plan = RenderPlan.of(studio);
            RenderPlan otherSeed =
                    RenderPlan.of(studio.withSettings(studio.settings().withSeed(99)));
            float[] reference = renderer.render(otherSeed, new Quality.Samples(REFERENCE_SAMPLES))
                    .image()
                    .rgb();
            // what is compiled meanwhile is not counted
            for (int i = 0; i < WARM_UP; i++) {
                renderer.render(plan, new Quality.TargetError(ERRORS[1]));
            }
            for (double error : ERRORS) {
                double[] seconds = new double[TURNS];
                double found = 0;
                for (int round = 0; round < TURNS; round++) {
                    double start = processorSeconds();
                    RenderJob job = renderer.render(plan, new Quality.TargetError(error));
                    seconds[round] = processorSeconds() - start;
                    found = rootMeanSquare(light(job.image().rgb()), light(reference));
                }
                points.add(point(OWN, error, seconds, found));
            }
        }
        return points;
    }

    /** POV-Ray's pictures by which of its settings is the cheapest for their error. */
    private static List<StudyPoint> others(String version) throws IOException, InterruptedException {
        double[] reference = grid(TIMES_OF_REFERENCE, MOST_GRID).take().light();
        List<StudyPoint> points = new ArrayList<>();
        List<Setting> settings = settings();
        for (int setting = 0; setting < settings.size(); setting++) {
            double[] seconds = new double[TURNS];
            double found = 0;
            for (int round = 0; round < TURNS; round++) {
                PovRay.Taken taken = settings.get(setting).take();
                seconds[round] = taken.seconds();
                found = rootMeanSquare(taken.light(), reference);
            }
            points.add(point("POV-Ray " + version + ", cheapest setting", setting, seconds, found));
        }
        return cheapest(points);
    }

    /**
     * How POV-Ray takes a picture.
     *
     * @param times how many times as wide and as high it is before the means of its pixels are taken
     * @param antialiasing its options for that
     */
    private record Setting(int times, String... antialiasing) {

        PovRay.Taken take() throws IOException, InterruptedException {
            PovRay.Taken taken = PovRay.take(times * WIDTH, times * HEIGHT, antialiasing);
            double[] means = new double[3 * WIDTH * HEIGHT];
            for (int i = 0; i < taken.light().length; i++) {
                int row = i / (3 * times * WIDTH) / times;
                int column = i / 3 % (times * WIDTH) / times;
                means[3 * (row * WIDTH + column) + i % 3] += taken.light()[i] / (times * times);
            }
            return new PovRay.Taken(taken.seconds(), means);
        }
    }

    /** More samples where neighbours differ at all, in a jittered grid of that many rows. */
    private static Setting grid(int times, int rows) {
        return new Setting(times, "+AM1", "+A0.0", "+R" + rows);
    }

    private static List<Setting> settings() {
        List<Setting> settings = new ArrayList<>();
        for (int rows = LEAST_GRID; rows <= MOST_GRID; rows++) {
            settings.add(grid(1, rows));
            settings.add(grid(2, rows));
        }
        for (double difference : DIFFERENCES) {
            for (int depth = LEAST_DEPTH; depth <= MOST_DEPTH; depth++) {
                settings.add(new Setting(1, "+AM2", "+A" + difference, "+R" + depth));
            }
        }
        for (int times = 2; times <= MOST_TIMES; times++) {
            settings.add(new Setting(times, "-A"));
        }
        return settings;
    }

    /** Those than which no cheaper one has as small an error, the cheapest first. */
    private static List<StudyPoint> cheapest(List<StudyPoint> points) {
        List<StudyPoint> kept = new ArrayList<>();
        points.sort(Comparator.comparingDouble(point -> point.seconds().middle()));
        for (StudyPoint point : points) {
            double best = kept.isEmpty()
                    ? Double.POSITIVE_INFINITY
                    : last(kept).error().middle();
            if (point.error().middle() < best) {
                kept.add(point);
            }
        }
        return kept;
    }

    private static StudyPoint last(List<StudyPoint> points) {
        return points.get(points.size() - 1);
    }

    private static StudyPoint point(String method, double setting, double[] seconds, double error) {
        return new StudyPoint(PROBLEM, method, setting, 1, Spread.of(seconds), Spread.exact(error), error, 0);
    }

    /**
     * The cost of an error, on the straight line of the logarithms through the two points around it; that of the
     * cheapest point if it is as good already.
     */
    static double costTo(double error, List<StudyPoint> points, ToDoubleFunction<StudyPoint> cost) {
        StudyPoint before = points.get(0);
        if (before.error().middle() <= error) {
            return cost.applyAsDouble(before);
        }
        for (StudyPoint after : points) {
            if (after.error().middle() <= error) {
                double part = Math.log(before.error().middle() / error)
                        / Math.log(before.error().middle() / after.error().middle());
                return cost.applyAsDouble(before)
                        * Math.pow(cost.applyAsDouble(after) / cost.applyAsDouble(before), part);
            }
            before = after;
        }
        return Double.NaN;
    }

    private static double[] light(float[] rgb) {
        double[] light = new double[rgb.length];
        for (int i = 0; i < light.length; i++) {
            // POV-Ray's picture holds nothing brighter than white
            light[i] = Math.min(1, rgb[i]);
        }
        return light;
    }

    private static double rootMeanSquare(double[] one, double[] other) {
        double squares = 0;
        for (int i = 0; i < one.length; i++) {
            squares += (one[i] - other[i]) * (one[i] - other[i]);
        }
        return Math.sqrt(squares / one.length);
    }

    /** What this process has used of the processor. */
    private static double processorSeconds() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                        .getProcessCpuTime()
                / 1e9;
    }
}
