package tompkins.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * Whether the error of photographs is what {@link Quality.TargetError} promises: all scenes, several promises and
 * seeds.
 *
 * @param studios photographs
 * @param seed of the first of several runs
 * @param width of the photographs in pixels
 * @param referenceSamples least number of samples per pixel of the references
 */
record PromisedErrors(Map<String, Studio> studios, long seed, int width, int referenceSamples) {

    private static final String PROBLEM = "promise";
    private static final double[] PROMISES = {0.01, 0.003, 0.001};
    private static final int SEEDS = 3;
    private static final double TOLERANCE = 1.25;
    private static final double SHARE = 0.95;

    /** The references are refined until their error is at most this. */
    private static final double WANTED_REFERENCE_ERROR = 0.0004;

    private static final double MOST_REFERENCE_ERROR = 0.0005;

    /** One trial for each photograph, each promise and each seed. */
    List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        studios.forEach((name, studio) -> {
            Studio small = Photographs.small(studio, width);
            ScenePixels pixels =
                    new ScenePixels(small, ScenePixels.ALL, referenceSamples, WANTED_REFERENCE_ERROR, () -> false);
            for (double promise : PROMISES) {
                for (long run = seed; run < seed + SEEDS; run++) {
                    List<Studio> seeded =
                            List.of(small.withSettings(small.settings().withSeed(run)));
                    Supplier<Figures> measurer = () -> pixels.photographed(seeded, new Quality.TargetError(promise));
                    trials.add(new Trial(PROBLEM + ":" + name + ":seed " + run, kind(studio), promise, measurer, name));
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

    static Chart chart() {
        return new Chart(
                        PROBLEM,
                        StudyText.format(
                                "Error found against error promised, all scenes (%.2f times is allowed)", TOLERANCE),
                        Chart.setting("promised RMS error (--error)"),
                        Chart.ERROR,
                        false,
                        "")
                .withGuides(List.of(
                        new Chart.Guide("found = promised", 1),
                        new Chart.Guide(StudyText.format("%.2f times that", TOLERANCE), TOLERANCE)));
    }

    /** The run with the largest of some figure. */
    private static Measurement worst(List<Measurement> runs, ToDoubleFunction<Measurement> figure) {
        return runs.stream().max(Comparator.comparingDouble(figure)).orElseThrow();
    }

    private static String name(Measurement run) {
        return run.problem().substring(run.problem().indexOf(':') + 1).replace(":", ", ") + " at " + run.setting();
    }

    /** Says whether the promises are kept. */
    static void conclude(List<Measurement> all, Conclusion conclusion) {
        List<Measurement> runs = all.stream()
                .filter(point -> point.problem().startsWith(PROBLEM + ":"))
                .toList();
        if (runs.isEmpty()) {
            return;
        }
        long kept = runs.stream().filter(run -> excess(run) <= TOLERANCE).count();
        conclusion.say("promise.answer", Math.floor(100.0 * kept / runs.size()));
        Measurement worst = worst(runs, PromisedErrors::excess);
        conclusion.demand(
                kept >= SHARE * runs.size(),
                "promise.kept",
                TOLERANCE,
                100 * SHARE,
                kept,
                runs.size(),
                excess(worst),
                name(worst));
        double reference = worst(runs, Measurement::floor).floor();
        conclusion.demand(reference <= MOST_REFERENCE_ERROR, "promise.reference", MOST_REFERENCE_ERROR, reference);
    }

    /** The error, divided by what was promised, without that of the reference, which adds to it in squares. */
    private static double excess(Measurement point) {
        double error = point.medianError();
        return Math.sqrt(Math.max(0, error * error - point.floor() * point.floor())) / point.setting();
    }
}
