package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * Whether the error of photographs is what {@link Quality.TargetError} promises: all scenes, several promises and
 * seeds.
 */
final class PromisedErrors {

    private static final String PROBLEM = "promise";
    private static final double[] PROMISES = {0.01, 0.003, 0.001};
    private static final int SEEDS = 3;
    private static final double TOLERANCE = 1.25;
    private static final double SHARE = 0.95;

    /** The references are refined until their error is at most this. */
    private static final double WANTED_REFERENCE_ERROR = 0.0004;

    private static final double MOST_REFERENCE_ERROR = 0.0005;

    private final Map<String, Studio> small = new LinkedHashMap<>();
    private final long seed;
    private final int referenceSamples;

    /**
     * The question for some photographs.
     *
     * @param width of the photographs in pixels
     * @param referenceSamples least number of samples per pixel of the references
     */
    PromisedErrors(Map<String, Studio> studios, long seed, int width, int referenceSamples) {
        this.seed = seed;
        this.referenceSamples = referenceSamples;
        studios.forEach((name, studio) -> small.put(name, Photographs.small(studio, width)));
    }

    List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        small.forEach((name, studio) -> {
            ScenePixels pixels =
                    new ScenePixels(studio, ScenePixels.ALL, referenceSamples, WANTED_REFERENCE_ERROR, () -> false);
            String kind = kind(studio);
            for (double promise : PROMISES) {
                for (long run = seed; run < seed + SEEDS; run++) {
                    String problem = PROBLEM + ":" + name + ":seed " + run;
                    Studio seeded = studio.withSettings(studio.settings().withSeed(run));
                    trials.add(new Trial(
                            problem,
                            kind,
                            promise,
                            () -> pixels.photographed(List.of(seeded), new Quality.TargetError(promise))));
                }
            }
        });
        return trials;
    }

    private static String kind(Studio studio) {
        if (RenderPlan.of(studio).blursInTime()) {
            return "long exposures";
        }
        return studio.camera().hasWideAperture() ? "wide apertures" : "pinholes";
    }

    Chart chart() {
        return new Chart(
                        PROBLEM,
                        Finding.text(
                                "Error found against error promised, all scenes (%.2f times is allowed)", TOLERANCE),
                        Chart.setting("promised RMS error (--error)"),
                        Chart.ERROR,
                        false)
                .withGuides(List.of(
                        new Chart.Guide("found = promised", 1),
                        new Chart.Guide(Finding.text("%.2f times that", TOLERANCE), TOLERANCE)));
    }

    /** The share of the photographs that keep what was promised. */
    static double share(List<Measurement> all) {
        List<Measurement> runs = runs(all);
        return (double) kept(runs) / runs.size();
    }

    private static List<Measurement> runs(List<Measurement> all) {
        return all.stream()
                .filter(point -> point.problem().startsWith(PROBLEM + ":"))
                .toList();
    }

    private static long kept(List<Measurement> runs) {
        return runs.stream().filter(run -> excess(run) <= TOLERANCE).count();
    }

    /** What the measurements must show. */
    static List<Finding> findings(List<Measurement> all) {
        List<Measurement> runs = runs(all);
        if (runs.isEmpty()) {
            return List.of();
        }
        long kept = kept(runs);
        Measurement worst =
                runs.stream().reduce((a, b) -> excess(a) > excess(b) ? a : b).orElseThrow();
        double reference = runs.stream().mapToDouble(Measurement::floor).max().orElseThrow();
        return List.of(
                Finding.of(
                        kept >= SHARE * runs.size(),
                        Finding.text("Photographs that err by at most %.2f times what was promised", TOLERANCE),
                        Finding.text("%.0f %%", 100 * SHARE),
                        "%d of %d; the worst errs by %.2f times (%s at %s)",
                        kept,
                        runs.size(),
                        excess(worst),
                        worst.problem().substring(PROBLEM.length() + 1).replace(":", ", "),
                        worst.setting()),
                Finding.of(
                        reference <= MOST_REFERENCE_ERROR,
                        "Largest error of the references themselves, from the difference of their halves",
                        Finding.text("at most %.4f, half of the smallest promise", MOST_REFERENCE_ERROR),
                        "%.5f",
                        reference));
    }

    /** The error, divided by what was promised, without that of the reference, which adds to it in squares. */
    private static double excess(Measurement point) {
        double error = point.medianError();
        return Math.sqrt(Math.max(0, error * error - point.floor() * point.floor())) / point.setting();
    }
}
