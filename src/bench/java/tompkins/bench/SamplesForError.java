package tompkins.bench;

import java.awt.BasicStroke;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.jfree.chart.ChartUtils;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.renderer.xy.XYItemRenderer;
import tompkins.image.LinearImage;
import tompkins.image.Palette;
import tompkins.image.PictureDifference;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.Renderer;
import tompkins.render.SampleChoice;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.study.Chart;
import tompkins.study.ChartDrawing;
import tompkins.study.ChartStyle;
import tompkins.study.Spread;
import tompkins.study.StudyPoint;
import tompkins.trace.RenderPlan;

/**
 * How many samples a figure takes for an error: by the choice of {@code --error}, by the same choice that begins with
 * fewer samples, and by a choice that was told how wrong each pixel is with each number of samples. No program can know
 * that before it has taken them, so that this curve says how much could be gained at most. Samples are counted: the
 * speed of the machine does not matter.
 */
final class SamplesForError {

    /** The chart, beside the page. */
    static final String CHART = "samples-for-an-error.png";

    private static final String PROBLEM = "samples";
    private static final String PROGRAM = "the program";
    private static final String FEW_FIRST = "4 samples first";
    private static final String ERRORS_KNOWN = "errors known";
    private static final int FEW = 4;

    /** The strokes of the program's choice, of few samples first, and of known errors. */
    private static final List<BasicStroke> STROKES = List.of(new BasicStroke(2.4f), dashed(2), dashed(8));

    private static final int WIDTH = 660;
    private static final int HEIGHT = 400;

    /** The error at which the choices are compared. */
    private static final double COMPARED = 0.01;

    private static final double[] WANTED = {0.04, 0.028, 0.02, 0.014, 0.01, 0.007, 0.005};
    private static final int REFERENCE_SAMPLES = 512;
    private static final long REFERENCE_SEED = 9001;

    /** How wrong pixels are was found with other seeds than those of the pictures. */
    private static final long FIRST_SEED_OF_VARIANCES = 101;

    /** Pictures from which the variance of each pixel comes. */
    private static final int PICTURES = 32;

    /** The most samples whose variances are measured, two to this power; beyond, they fall by the program's law. */
    private static final int MEASURED_DOUBLINGS = 5;

    /** The most samples of a pixel, two to this power. */
    private static final int MOST_DOUBLINGS = 11;

    /** The gain for which one more sample is taken: the first, the last, and from one to the next. */
    private static final double FIRST_GAIN = 1e-3;

    private static final double LAST_GAIN = 5e-8;
    private static final double NEXT_GAIN = 0.4;

    private final Studio studio;
    private final int seeds;
    private final String name;
    private final Renderer renderer;
    private final LinearImage reference;

    /** The mean square of the errors of the reference itself. */
    private final double ofReference;

    private SamplesForError(String name, Studio figure, int width, int seeds, Renderer renderer)
            throws InterruptedException {
        this.name = name;
        this.seeds = seeds;
        this.renderer = renderer;
        studio = figure.withSettings(figure.settings().withSize(width, width * 3 / 4));
        reference = picture(REFERENCE_SEED, REFERENCE_SAMPLES);
        LinearImage other = picture(REFERENCE_SEED + 1, REFERENCE_SAMPLES);
        double halves = PictureDifference.ofLight(reference, other);
        ofReference = halves * halves / 4;
        for (int i = 0; i < reference.rgb().length; i++) {
            reference.rgb()[i] = (reference.rgb()[i] + other.rgb()[i]) / 2;
        }
    }

    /** Counts samples, prints what the page says by hand, and draws the chart. */
    static void measure(int width, int seeds, Path folder) throws IOException, InterruptedException {
        List<StudyPoint> all = new ArrayList<>();
        try (Renderer renderer = new Renderer()) {
            List<SamplesForError> figures = List.of(
                    new SamplesForError("fig1a", PaperStudios.fig1a(), width, seeds, renderer),
                    new SamplesForError("fig1b", PaperStudios.fig1b(), width, seeds, renderer),
                    new SamplesForError("fig3a", PaperStudios.fig3a(), width, seeds, renderer));
            for (SamplesForError figure : figures) {
                List<StudyPoint> program = figure.chosen(PROGRAM, 0);
                List<StudyPoint> few = figure.chosen(FEW_FIRST, FEW);
                List<StudyPoint> known = figure.known();
                double samples = samplesTo(program);
                System.out.printf(
                        Locale.ROOT,
                        "%s to a true error of %s: %.3g samples of a pixel, beginning with %d %.3f, errors known %.3f of that%n",
                        figure.name,
                        COMPARED,
                        samples,
                        FEW,
                        samplesTo(few) / samples,
                        samplesTo(known) / samples);
                all.addAll(program);
                all.addAll(few);
                all.addAll(known);
            }
        }
        Chart chart = new Chart(
                PROBLEM,
                "Samples for an error, " + width + " x " + width * 3 / 4,
                new Chart.Axis("samples of a pixel", point -> Spread.exact(point.setting())),
                new Chart.Axis("true RMS error in linear light (white = 1)", StudyPoint::error),
                false,
                "");
        Files.createDirectories(folder);
        Files.write(folder.resolve(CHART), png(ChartDrawing.drawing(chart, all, ChartStyle.PRINTED)));
    }

    /** A small file, in which each figure has a colour and each choice a stroke. */
    private static byte[] png(JFreeChart chart) throws IOException {
        XYItemRenderer curves = chart.getXYPlot().getRenderer();
        int choices = STROKES.size();
        for (int i = 0; i < chart.getXYPlot().getSeriesCount(); i++) {
            curves.setSeriesPaint(i, ChartStyle.PRINTED.curve(i / choices + 1));
            curves.setSeriesStroke(i, STROKES.get(i % choices));
        }
        BufferedImage drawn = chart.createBufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB, null);
        return ChartUtils.encodeAsPNG(Palette.reduced(drawn), false, 9);
    }

    /** The samples for the error, on the straight line of the logarithms through the two points around it. */
    private static double samplesTo(List<StudyPoint> points) {
        StudyPoint before = points.get(0);
        if (before.error().middle() <= COMPARED) {
            return before.setting();
        }
        for (StudyPoint after : points) {
            if (after.error().middle() <= COMPARED) {
                double part = Math.log(before.error().middle() / COMPARED)
                        / Math.log(before.error().middle() / after.error().middle());
                return before.setting() * Math.pow(after.setting() / before.setting(), part);
            }
            before = after;
        }
        return Double.NaN;
    }

    private static BasicStroke dashed(float length) {
        return new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {length, 3}, 0);
    }

    private RenderPlan plan(long seed) {
        return RenderPlan.of(studio.withSettings(studio.settings().withSeed(seed)));
    }

    private LinearImage picture(long seed, int samples) throws InterruptedException {
        return renderer.render(plan(seed), new Quality.Samples(samples)).image();
    }

    /** The pictures of all wanted errors, beginning with a number of samples; 0 for that of the program. */
    private List<StudyPoint> chosen(String method, int first) throws InterruptedException {
        List<StudyPoint> points = new ArrayList<>();
        for (double wanted : WANTED) {
            List<RenderJob> jobs = new ArrayList<>();
            for (int seed = 1; seed <= seeds; seed++) {
                jobs.add(
                        first == 0
                                ? renderer.render(plan(seed), new Quality.TargetError(wanted))
                                : SampleChoice.adaptive(renderer, plan(seed), first, wanted));
            }
            points.add(point(method, jobs));
        }
        return points;
    }

    /** The pictures of the choice that knows the errors, from few samples to many. */
    private List<StudyPoint> known() throws InterruptedException {
        double[][] variances = new double[MEASURED_DOUBLINGS + 1][];
        for (int doublings = 0; doublings <= MEASURED_DOUBLINGS; doublings++) {
            variances[doublings] = variances(1 << doublings);
        }
        List<StudyPoint> points = new ArrayList<>();
        for (double gain = FIRST_GAIN; gain > LAST_GAIN; gain *= NEXT_GAIN) {
            double least = gain;
            int[] samples = IntStream.range(0, variances[0].length)
                    .map(pixel -> 1 << best(pixel, least, variances))
                    .toArray();
            List<RenderJob> jobs = new ArrayList<>();
            for (int seed = 1; seed <= seeds; seed++) {
                jobs.add(SampleChoice.given(renderer, plan(seed), samples));
            }
            points.add(point(ERRORS_KNOWN, jobs));
        }
        return points;
    }

    /** The doublings of the samples of a pixel after which nothing gains as much as this with each further sample. */
    private static int best(int pixel, double gain, double[][] variances) {
        return IntStream.rangeClosed(0, MOST_DOUBLINGS)
                .boxed()
                .min(Comparator.comparingDouble(
                        doublings -> variance(pixel, doublings, variances) + gain * (1 << doublings)))
                .orElseThrow();
    }

    private static double variance(int pixel, int doublings, double[][] variances) {
        int measured = Math.min(doublings, MEASURED_DOUBLINGS);
        return variances[measured][pixel] * Math.pow(2, (measured - doublings) * SampleChoice.POWER);
    }

    /** The variance of each pixel with a number of samples, averaged over the channels. */
    private double[] variances(int samples) throws InterruptedException {
        float[] mean = reference.rgb();
        double[] variances = new double[mean.length / 3];
        for (int picture = 0; picture < PICTURES; picture++) {
            float[] light = picture(FIRST_SEED_OF_VARIANCES + picture, samples).rgb();
            for (int i = 0; i < light.length; i++) {
                variances[i / 3] += (light[i] - mean[i]) * (light[i] - mean[i]) / (3.0 * PICTURES);
            }
        }
        return variances;
    }

    /** The medians of the samples of a pixel and of the errors. */
    private StudyPoint point(String choice, List<RenderJob> jobs) {
        double[] samples = jobs.stream()
                .mapToDouble(job -> (double) job.samples() / studio.settings().pixels())
                .toArray();
        double[] errors = jobs.stream().mapToDouble(this::trueError).toArray();
        return new StudyPoint(
                PROBLEM,
                name + ", " + choice,
                Measure.median(samples),
                0,
                Spread.exact(0),
                Spread.exact(Measure.median(errors)),
                0,
                0);
    }

    private double trueError(RenderJob job) {
        double error = PictureDifference.ofLight(job.image(), reference);
        return Math.sqrt(Math.max(0, error * error - ofReference));
    }
}
