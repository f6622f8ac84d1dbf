package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
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

    static final String HONESTY = "honesty";
    static final String ADAPTIVE = "adaptive (--error)";
    static final String FIXED = "the same number everywhere";
    private static final String GRID = "regular grid";

    private static final double TOLERANCE = 1.25;
    private static final double SHARE = 0.95;
    private static final double[] TARGETS = {0.01, 0.003, 0.001};
    private static final int MOST_SAMPLES = 1024;

    private final long seed;
    private final int width;
    private final int referenceSamples;
    private final Map<String, Studio> compared;
    private final Map<String, Studio> promised;

    /**
     * The study.
     *
     * @param compared pinhole photographs on which methods are compared
     * @param promised photographs on which the promised error is compared with the true one
     * @param width width of the promised photographs in pixels; the compared ones are twice as wide
     * @param referenceSamples samples for each pixel of the references
     */
    AntialiasingStudy(
            Map<String, Studio> compared, Map<String, Studio> promised, long seed, int width, int referenceSamples) {
        this.compared = compared;
        this.promised = promised;
        this.seed = seed;
        this.width = width;
        this.referenceSamples = referenceSamples;
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
        return "seed " + seed + ", width " + width + ", references " + referenceSamples + " samples, scenes "
                + compared.keySet() + " and " + promised.keySet();
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        compared.forEach((name, studio) -> {
            Studio small = small(studio, 2 * width);
            ScenePixels pixels = whole(small);
            for (int samples = 4; samples <= MOST_SAMPLES; samples *= 4) {
                int count = samples;
                // a grid goes through the centre of the lens: that is another picture if the lens is wide
                if (!studio.camera().hasWideLens()) {
                    trials.add(new Trial(name, GRID, count, cancelled -> grid(name, pixels, count, cancelled)));
                }
                trials.add(new Trial(
                        name,
                        FIXED,
                        count,
                        cancelled ->
                                rendered(name, FIXED, count, small, pixels, new Quality.Samples(count), cancelled)));
            }
            for (double target = 0.032; target > 0.0009; target /= 2) {
                double error = target;
                trials.add(new Trial(
                        name,
                        ADAPTIVE,
                        error,
                        cancelled -> rendered(
                                name, ADAPTIVE, error, small, pixels, new Quality.TargetError(error), cancelled)));
            }
        });
        promised.forEach((name, studio) -> {
            Studio small = small(studio, width);
            ScenePixels pixels = whole(small);
            for (double target : TARGETS) {
                trials.add(new Trial(
                        HONESTY + ":" + name,
                        lens(small),
                        target,
                        cancelled -> rendered(
                                HONESTY + ":" + name,
                                lens(small),
                                target,
                                small,
                                pixels,
                                new Quality.TargetError(target),
                                cancelled)));
            }
        });
        return trials;
    }

    private static String lens(Studio studio) {
        return studio.camera().hasWideLens() ? "wide lenses" : "pinholes";
    }

    private Studio small(Studio studio, int columns) {
        int rows = Math.max(
                1, columns * studio.settings().height() / studio.settings().width());
        return studio.withSettings(studio.settings().withSize(columns, rows).withSeed(seed));
    }

    private ScenePixels whole(Studio small) {
        return new ScenePixels(
                small, small.settings().width() * small.settings().height(), referenceSamples);
    }

    private Measurement grid(String name, ScenePixels pixels, int samples, BooleanSupplier cancelled) {
        double[] reference = pixels.reference(cancelled);
        Repeats runs = new Repeats();
        long start = System.nanoTime();
        double[] light = pixels.light(new GridPattern(samples), samples, cancelled);
        runs.add(ErrorNorm.of(light, reference), (System.nanoTime() - start) / 1e9);
        return runs.measurement(name, GRID, samples, (double) samples * pixels.count(), pixels.floor());
    }

    private Measurement rendered(
            String problem,
            String method,
            double setting,
            Studio studio,
            ScenePixels pixels,
            Quality quality,
            BooleanSupplier cancelled) {
        double[] reference = pixels.reference(cancelled);
        RenderJob job = photograph(RenderPlan.of(studio), quality, cancelled);
        float[] rgb = job.image().rgb();
        double[] light = new double[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            light[i] = rgb[i];
        }
        RenderReport report = job.report();
        Repeats runs = new Repeats();
        runs.add(ErrorNorm.of(light, reference), report.time().toNanos() / 1e9);
        return runs.measurement(problem, method, setting, report.samples(), pixels.floor());
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
        for (String name : compared.keySet()) {
            charts.add(new Chart(name, name + ", pinhole", Chart.across("rays", Measurement::rays), Chart.ERROR, true));
        }
        charts.add(new Chart(
                HONESTY,
                "Error found against error promised, all scenes (1.25 times is allowed)",
                Chart.setting("promised RMSE (--error)"),
                Chart.ERROR,
                false));
        return charts;
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (String name : compared.keySet()) {
            findings.add(saving(name, all));
        }
        if (!promised.isEmpty()) {
            findings.add(honesty(all));
        }
        return findings;
    }

    /** Compares the rays that both ways need for the same error, by the laws fitted to them. */
    private static Finding saving(String name, List<Measurement> all) {
        PowerLaw fixed = PowerLaw.ofError(points(name, FIXED, all), Measurement::rays);
        PowerLaw grid = PowerLaw.ofError(points(name, GRID, all), Measurement::rays);
        List<Measurement> adaptive = points(name, ADAPTIVE, all);
        double log = 0;
        for (Measurement point : adaptive) {
            double needed = Math.pow(point.error().middle() / fixed.factor(), 1 / fixed.slope());
            log += Math.log(needed / point.rays()) / adaptive.size();
        }
        double saving = Math.exp(log);
        return Finding.check(
                saving > 1,
                "%s: a regular grid falls with power %.2f, low-discrepancy points with %.2f; for the same error, samples where"
                        + " they are needed take %.1f times fewer rays (more than 1 times is demanded).",
                name,
                grid.slope(),
                fixed.slope(),
                saving);
    }

    private static Finding honesty(List<Measurement> all) {
        List<Measurement> runs = all.stream()
                .filter(point -> point.problem().startsWith(HONESTY + ":"))
                .toList();
        long kept = runs.stream()
                .filter(point -> beyondReference(point) <= TOLERANCE * point.setting())
                .count();
        Measurement worst = runs.stream()
                .reduce((a, b) -> beyondReference(a) / a.setting() > beyondReference(b) / b.setting() ? a : b)
                .orElseThrow();
        return Finding.check(
                kept >= SHARE * runs.size(),
                "%d of %d photographs err by at most %.2f times what was promised (95 %% must); the worst, %s at %.3f, by %.2f"
                        + " times.",
                kept,
                runs.size(),
                TOLERANCE,
                worst.problem().substring(HONESTY.length() + 1),
                worst.setting(),
                beyondReference(worst) / worst.setting());
    }

    /** The error without that of the reference, which adds to it in squares. */
    private static double beyondReference(Measurement point) {
        double error = point.error().middle();
        return Math.sqrt(Math.max(0, error * error - point.floor() * point.floor()));
    }

    private static List<Measurement> points(String problem, String method, List<Measurement> all) {
        return all.stream()
                .filter(point ->
                        point.problem().equals(problem) && point.method().equals(method))
                .toList();
    }
}
