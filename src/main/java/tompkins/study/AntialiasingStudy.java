package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import tompkins.image.LinearImage;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderListener;
import tompkins.render.RenderReport;
import tompkins.render.Renderer;
import tompkins.render.Tile;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Whether samples are better shared evenly or put where they are needed, and whether the error is what was promised. */
final class AntialiasingStudy implements Study {

    static final String ADAPTIVE = "where needed";
    static final String FIXED = "the same number everywhere";
    static final String CENTRE = "one sample, in the centre";
    private static final String ANYWHERE = "one sample, anywhere";
    private static final String GRID = "regular grid";
    private static final int MOST_SAMPLES = 256;
    private static final int SEEDS = 3;
    private static final int PROMISED_PART = 3;

    private final long seed;
    private final int width;
    private final int referenceSamples;
    private final Map<String, Studio> compared;
    private final Map<String, Studio> promised;
    private final Honesty honesty;

    /**
     * The study.
     *
     * @param compared pinhole photographs on which methods are compared
     * @param promised photographs on which the promised error is compared with the true one
     * @param width width of the compared photographs in pixels; the promised ones have a third of it
     * @param referenceSamples samples per pixel of the references of the compared photographs; those of the promised
     *     ones begin with a quarter and have as many as it takes
     */
    AntialiasingStudy(
            Map<String, Studio> compared, Map<String, Studio> promised, long seed, int width, int referenceSamples) {
        this.compared = compared;
        this.promised = promised;
        this.seed = seed;
        this.width = width;
        this.referenceSamples = referenceSamples;
        honesty = new Honesty(promised, seed, width / PROMISED_PART, referenceSamples / 4);
    }

    @Override
    public String name() {
        return "antialiasing";
    }

    @Override
    public String question() {
        return "Edges inside pixels need several samples, flat pixels one. Is it better to give all pixels the same number,"
                + " or to put samples where the picture is still wrong? And is the picture as good as `render --error`"
                + " promises, on every scene?";
    }

    @Override
    public String settings() {
        return "seeds " + seed + " to " + (seed + SEEDS - 1) + ", width " + width + " and " + width / PROMISED_PART
                + ", references " + referenceSamples + " samples or as many as it takes, scenes "
                + StudySetup.settings(compared) + " and " + StudySetup.settings(promised);
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        compared.forEach((name, studio) -> {
            Studio small = small(studio, width);
            ScenePixels pixels = ScenePixels.all(small, referenceSamples, Double.POSITIVE_INFINITY);
            // places in the centre of the lens make another picture if the lens is wide
            boolean pinhole = !studio.camera().hasWideAperture();
            if (pinhole) {
                trials.add(trial(name, CENTRE, 1, small, pixels, new Quality.Samples(1)));
                trials.add(new Trial(
                        name,
                        ANYWHERE,
                        1,
                        cancelled -> placed(name, ANYWHERE, new ProgramPattern(seed, true), 1, pixels, cancelled)));
            }
            for (int samples = 4; samples <= MOST_SAMPLES; samples *= 4) {
                int count = samples;
                if (pinhole) {
                    trials.add(new Trial(
                            name,
                            GRID,
                            count,
                            cancelled -> placed(name, GRID, new GridPattern(count), count, pixels, cancelled)));
                }
                trials.add(trial(name, FIXED, count, small, pixels, new Quality.Samples(count)));
            }
            for (double target = 0.032; target > 0.0009; target /= 2) {
                trials.add(trial(name, ADAPTIVE, target, small, pixels, new Quality.TargetError(target)));
            }
        });
        trials.addAll(honesty.trials());
        return trials;
    }

    /** A trial of several seeds. */
    private Trial trial(
            String name, String method, double setting, Studio studio, ScenePixels pixels, Quality quality) {
        List<Studio> seeded = new ArrayList<>();
        for (long run = seed; run < seed + SEEDS; run++) {
            seeded.add(studio.withSettings(studio.settings().withSeed(run)));
        }
        return new Trial(
                name,
                method,
                setting,
                cancelled -> rendered(name, method, setting, seeded, pixels, quality, cancelled));
    }

    /** A studio with a smaller picture of the same shape. */
    static Studio small(Studio studio, int columns) {
        int rows = Math.max(
                1, columns * studio.settings().height() / studio.settings().width());
        return studio.withSettings(studio.settings().withSize(columns, rows));
    }

    private static Measurement placed(
            String name,
            String method,
            SamplePattern pattern,
            int samples,
            ScenePixels pixels,
            BooleanSupplier cancelled) {
        double[] reference = pixels.reference(cancelled);
        Repeats runs = new Repeats();
        long start = System.nanoTime();
        double[] light = pixels.light(pattern, samples, cancelled);
        runs.add(ErrorNorm.of(light, reference), (System.nanoTime() - start) / 1e9);
        return runs.measurement(name, method, samples, (double) samples * pixels.count(), pixels.floor());
    }

    /** The measurement of a quality with one run for each studio, which differ in their seeds. */
    static Measurement rendered(
            String problem,
            String method,
            double setting,
            List<Studio> studios,
            ScenePixels pixels,
            Quality quality,
            BooleanSupplier cancelled) {
        double[] reference = pixels.reference(cancelled);
        Repeats runs = new Repeats();
        double samples = 0;
        for (Studio studio : studios) {
            RenderJob job = photograph(RenderPlan.of(studio), quality, cancelled);
            RenderReport report = job.report();
            samples += (double) report.samples() / studios.size();
            runs.add(ErrorNorm.of(values(job.image()), reference), report.time().toNanos() / 1e9);
        }
        return runs.measurement(problem, method, setting, samples, pixels.floor());
    }

    /** The light of all pixels, three channels each. */
    static double[] values(LinearImage image) {
        float[] rgb = image.rgb();
        double[] values = new double[rgb.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = rgb[i];
        }
        return values;
    }

    /** Takes a photograph with one thread. */
    static RenderJob photograph(RenderPlan plan, Quality quality, BooleanSupplier cancelled) {
        RenderListener canceller = new RenderListener() {
            @Override
            public void tileDone(RenderJob job, Tile tile) {
                if (cancelled.getAsBoolean()) {
                    job.cancel();
                }
            }
        };
        try (Renderer renderer = new Renderer(1)) {
            RenderJob job = renderer.start(plan, quality, canceller);
            job.await();
            if (!job.isComplete()) {
                throw new CancellationException();
            }
            return job;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        compared.forEach((name, studio) -> charts.add(new Chart(
                        name,
                        name + (studio.camera().hasWideAperture() ? ", wide aperture" : ", pinhole"),
                        Chart.across("rays", Measurement::rays),
                        Chart.ERROR,
                        true)
                .withOwn(ADAPTIVE)));
        if (!promised.isEmpty()) {
            charts.add(honesty.chart());
        }
        return charts;
    }

    @Override
    public String answer(List<Measurement> all) {
        StringBuilder text =
                new StringBuilder("A scene that says nothing else gets one sample in the centre of each pixel,"
                        + " which is the cheapest picture there is.");
        for (String name : compared.keySet()) {
            for (Measurement centre : Measurement.of(name, CENTRE, all)) {
                double anywhere =
                        Measurement.of(name, ANYWHERE, all).get(0).error().middle();
                text.append(String.format(
                        Locale.ROOT,
                        " On %s its error is %.0f %% of that of a sample anywhere in the pixel.",
                        name,
                        100 * centre.error().middle() / anywhere));
            }
        }
        text.append(
                " Whoever wants a better one says how good it has to be: `--error` puts samples where the picture is still wrong.");
        for (String name : compared.keySet()) {
            text.append(String.format(
                    Locale.ROOT,
                    " On %s it needs %.0f %% of the rays that the same number everywhere needs for the same error.",
                    name,
                    100 / saving(name, all)));
        }
        if (!promised.isEmpty()) {
            text.append(String.format(
                    Locale.ROOT,
                    " What `--error` promises is kept, to within a quarter, by %.0f %% of the photographs of all scenes.",
                    Math.floor(100 * Honesty.share(all))));
        }
        return text.toString();
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (String name : compared.keySet()) {
            List<Measurement> centre = Measurement.of(name, CENTRE, all);
            if (!centre.isEmpty()) {
                double anywhere =
                        Measurement.of(name, ANYWHERE, all).get(0).error().middle();
                double error = centre.get(0).error().middle();
                findings.add(Finding.of(
                        error <= anywhere,
                        name + ": error of one sample in the centre of each pixel",
                        String.format(Locale.ROOT, "at most %.3g, that of one sample anywhere in it", anywhere),
                        "%.3g",
                        error));
            }
            double saving = saving(name, all);
            findings.add(Finding.of(
                    saving > 1,
                    name + ": rays of the same number everywhere, divided by those of `--error` for the same error",
                    "above 1",
                    "%.2f",
                    saving));
        }
        findings.addAll(Honesty.findings(all));
        return findings;
    }

    /** How many times fewer rays are needed for the same error, by the law fitted to the same number everywhere. */
    private static double saving(String name, List<Measurement> all) {
        PowerLaw fixed = PowerLaw.ofError(Measurement.of(name, FIXED, all), Measurement::rays);
        List<Measurement> adaptive = Measurement.of(name, ADAPTIVE, all);
        double log = 0;
        for (Measurement point : adaptive) {
            double needed = Math.pow(point.error().middle() / fixed.factor(), 1 / fixed.slope());
            log += Math.log(needed / point.rays()) / adaptive.size();
        }
        return Math.exp(log);
    }
}
