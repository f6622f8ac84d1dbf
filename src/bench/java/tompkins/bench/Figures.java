package tompkins.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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

    /** POV-Ray's grids of samples in each pixel. */
    private static final int[] GRIDS = {2, 3, 4, 6, 8};

    private static final int REFERENCE_GRID = 16;

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
                    secondsTo(0.01, others) / secondsTo(0.01, points)));
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

    private static List<StudyPoint> others(String version) throws IOException, InterruptedException {
        Studio studio = PaperStudios.fig1a();
        int width = studio.settings().width();
        int height = studio.settings().height();
        double[] reference = PovRay.take(WIDTH, HEIGHT, grid(REFERENCE_GRID)).light();
        List<StudyPoint> points = new ArrayList<>();
        for (int grid : GRIDS) {
            double[] seconds = new double[TURNS];
            double found = 0;
            for (int round = 0; round < TURNS; round++) {
                PovRay.Taken taken = PovRay.take(WIDTH, HEIGHT, grid(grid));
                seconds[round] = taken.seconds();
                found = rootMeanSquare(taken.light(), reference);
            }
            points.add(point("POV-Ray " + version + ", +R", grid, seconds, found));
        }
        return points;
    }

    /** More samples where neighbours differ at all, in a jittered grid of that many rows. */
    private static String[] grid(int rows) {
        return new String[] {"+AM1", "+A0.0", "+R" + rows};
    }

    private static StudyPoint point(String method, double setting, double[] seconds, double error) {
        return new StudyPoint(PROBLEM, method, setting, 1, Spread.of(seconds), Spread.exact(error), error, 0);
    }

    /** The seconds to an error, on the straight line of the logarithms through the two points around it. */
    private static double secondsTo(double error, List<StudyPoint> points) {
        for (int i = 1; i < points.size(); i++) {
            StudyPoint before = points.get(i - 1);
            StudyPoint after = points.get(i);
            if (after.error().middle() <= error) {
                double part = Math.log(before.error().middle() / error)
                        / Math.log(before.error().middle() / after.error().middle());
                return before.seconds().middle()
                        * Math.pow(after.seconds().middle() / before.seconds().middle(), part);
            }
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
