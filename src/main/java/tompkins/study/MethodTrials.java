package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.LongStream;
import tompkins.studio.Studio;
import tompkins.study.ExactProblem.Instance;

/** Trials of all methods: on problems with an exact answer, and on pixels of photographs. */
final class MethodTrials {

    private static final int SCENE_PIXELS = 768;
    private static final int SCENE_REPEATS = 3;

    private final long seed;
    private final ExactTrials exact;
    private final Map<String, ScenePixels> scenes = new LinkedHashMap<>();
    private final Map<String, SamplingMethod.Factory> methods;
    private final String settings;

    /**
     * The trials.
     *
     * @param studios the photographs, by name
     * @param mostSamples the largest number of samples per pixel; a power of 4
     * @param repeats runs of each trial with an exact answer
     * @param methods the methods, by name
     */
    MethodTrials(
            Map<String, Studio> studios,
            long seed,
            int mostSamples,
            int repeats,
            Map<String, SamplingMethod.Factory> methods) {
        this.seed = seed;
        this.methods = methods;
        exact = new ExactTrials(seed, mostSamples, repeats);
        settings = "seed " + seed + ", up to " + mostSamples + " samples, " + repeats + " runs, scenes "
                + StudySetup.settings(studios);
        studios.forEach((name, studio) -> scenes.put(
                name, new ScenePixels(studio, SCENE_PIXELS, 16 * mostSamples, Double.POSITIVE_INFINITY, () -> false)));
    }

    /** The settings of a study that makes these trials. */
    String settings() {
        return settings;
    }

    /** The names of the photographs. */
    Set<String> scenes() {
        return scenes.keySet();
    }

    /** Trials of all methods, with all numbers of samples, on a problem with an exact answer. */
    List<Trial> onProblem(String key, SampledSpace space, Function<SplittableRandom, Instance> problem) {
        List<Trial> trials = new ArrayList<>();
        methods.forEach((title, factory) -> exact.counts()
                .forEach(samples -> trials.add(
                        new Trial(key, title, samples, () -> exact.figures(problem, space, factory, samples)))));
        return trials;
    }

    /** Trials of all methods, with all numbers of samples, on the photographs. */
    List<Trial> onScenes() {
        List<Trial> trials = new ArrayList<>();
        scenes.forEach((name, pixels) -> methods.forEach((title, factory) -> exact.counts()
                .forEach(samples ->
                        trials.add(new Trial(name, title, samples, () -> figures(pixels, factory, samples))))));
        return trials;
    }

    private Figures figures(ScenePixels pixels, SamplingMethod.Factory factory, int samples) {
        if (samples <= 16) {
            Stopwatch.warmUp(() -> pixels.light(factory.pattern(0, samples, pixels.space()), samples));
        }
        List<SamplePattern> patterns = LongStream.range(seed, seed + SCENE_REPEATS)
                .mapToObj(run -> factory.pattern(run, samples, pixels.space()))
                .toList();
        return pixels.placed(patterns, samples);
    }
}
