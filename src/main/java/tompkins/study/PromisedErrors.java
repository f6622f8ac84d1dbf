package tompkins.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import tompkins.io.BundledScenes;
import tompkins.render.Quality;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * Whether the error of photographs is what {@link Quality.TargetError} promises: several promises and seeds.
 *
 * @param studios photographs
 * @param seed of the first of several runs
 * @param width of the photographs in pixels
 * @param referenceSamples least number of samples per pixel of the references
 */
record PromisedErrors(Map<String, Studio> studios, long seed, int width, int referenceSamples) {

    private static final String PROBLEM = "promise";
    private static final double[] PROMISES = {0.01, Quality.TargetError.DEFAULT.rootMeanSquare()};
    private static final double TOLERANCE = 1.25;
    private static final double KEPT = 0.95;

    /** Errors below this are those of single precision. */
    private static final double ROUNDING = 1e-6;

    /** The references are refined until their error is at most this: half of the smallest promise. */
    private static final double REFERENCE_ERROR = PROMISES[1] / 2;

    /** Those of all scenes of the program, as thorough as for the documents. */
    static PromisedErrors ofAllScenes(long seed) {
        return new PromisedErrors(BundledScenes.named(), seed, 32, 512);
    }

    /** What changes the figures. */
    String settings() {
        return StudyText.of(
                "promise.settings",
                Arrays.toString(PROMISES),
                seed,
                seed + PictureStudy.SEEDS - 1,
                width,
                referenceSamples,
                REFERENCE_ERROR,
                studios.size());
    }

    /** One trial for each photograph, each promise and each seed. */
    List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        studios.forEach((name, studio) -> {
            Studio small = Photographs.small(studio, width);
            ScenePixels pixels =
                    new ScenePixels(small, ScenePixels.ALL, referenceSamples, REFERENCE_ERROR, () -> false);
            for (double promise : PROMISES) {
                LongStream.range(seed, seed + PictureStudy.SEEDS)
                        .forEach(run -> trials.add(new Trial(
                                PROBLEM + ":" + name + ":seed " + run,
                                kind(studio),
                                promise,
                                () -> pixels.photographed(run, 1, new Quality.TargetError(promise)))));
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
                StudyText.format("Error found, divided by the error promised, all scenes (%.2f is allowed)", TOLERANCE),
                Chart.setting("promised RMS error (--error)"),
                new Chart.Axis("RMS error / promise", PromisedErrors::drawn),
                false,
                "");
    }

    /** Pictures of stars alone are exact but for rounding, and have no place on a logarithmic axis. */
    private static Spread drawn(StudyPoint run) {
        return Spread.exact(run.medianError() < ROUNDING ? 0 : run.medianError() / run.setting());
    }

    private static String sceneOf(StudyPoint run) {
        return run.problem().split(":")[1];
    }

    /** Says how often the promises are kept, and where they are not. */
    static void conclude(List<StudyPoint> all, Conclusion conclusion) {
        List<StudyPoint> runs = all.stream()
                .filter(point -> point.problem().startsWith(PROBLEM + ":"))
                .toList();
        List<StudyPoint> broken = runs.stream()
                .filter(run -> excess(run) > TOLERANCE)
                .sorted(Comparator.comparingDouble(PromisedErrors::excess).reversed())
                .toList();
        int kept = runs.size() - broken.size();
        long scenes = runs.stream().map(PromisedErrors::sceneOf).distinct().count();
        conclusion.say("promise.answer", kept, runs.size(), scenes);
        if (!broken.isEmpty()) {
            conclusion.say(
                    "promise.broken",
                    broken.stream()
                            .map(run ->
                                    StudyText.format("%s at %s (%.2f times)", sceneOf(run), run.setting(), excess(run)))
                            .collect(Collectors.joining(", ")));
        }
        conclusion.demand(kept >= KEPT * runs.size(), "promise.kept", TOLERANCE, 100 * KEPT, kept, runs.size());
        double reference = runs.stream().mapToDouble(StudyPoint::floor).max().orElseThrow();
        conclusion.demand(reference <= REFERENCE_ERROR, "promise.reference", REFERENCE_ERROR, reference);
    }

    /** The error, divided by what was promised, without that of the reference, which adds to it in squares. */
    private static double excess(StudyPoint point) {
        double error = point.medianError();
        return Math.sqrt(Math.max(0, error * error - point.floor() * point.floor())) / point.setting();
    }
}
