package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.LongStream;
import tompkins.studio.Studio;

/** How best to choose places on the lens, and in the pixel. */
final class ApertureStudy implements Study {

    static final String INDEPENDENCE = "independence";

    private static final int SAMPLES_OF_INDEPENDENCE = 16;
    private static final int SCENE_PIXELS = 768;
    private static final int SCENE_REPEATS = 3;

    private final long seed;
    private final int mostSamples;
    private final int repeats;
    private final ExactTrials exact;
    private final Map<String, ScenePixels> scenes;
    private final String sceneSettings;
    private final Map<String, SamplingMethod.Factory> methods;
    private final String program;
    private final ApertureFindings findings;

    /**
     * The study.
     *
     * @param studios photographs to be measured beside the problems with an exact answer, by name
     * @param mostSamples the largest number of samples per pixel; a power of 4
     * @param repeats runs of each trial with an exact answer
     * @param methods the methods, by name
     * @param program the name of the program's own method
     */
    ApertureStudy(
            Map<String, Studio> studios,
            long seed,
            int mostSamples,
            int repeats,
            Map<String, SamplingMethod.Factory> methods,
            String program) {
        this.seed = seed;
        this.mostSamples = mostSamples;
        this.repeats = repeats;
        exact = new ExactTrials(seed, mostSamples, repeats);
        this.methods = methods;
        this.program = program;
        sceneSettings = StudySetup.settings(studios);
        scenes = new LinkedHashMap<>();
        studios.forEach((name, studio) -> scenes.put(
                name, new ScenePixels(studio, SCENE_PIXELS, 16 * mostSamples, Double.POSITIVE_INFINITY, () -> false)));
        findings = new ApertureFindings(methods.keySet(), program, scenes.keySet());
    }

    @Override
    public String question() {
        return "A wide aperture sees each pixel through many points. How should they be chosen? Each method works out how"
                + " much of the lens sees a bright half-plane, disc or chequerboard, where the answer is known exactly,"
                + " and the light of pixels of photographs with a wide aperture. \"Random\" is the method of Dr TIM, the ray tracer of"
                + " the University of Glasgow with which the photographs of the paper were taken (Courtial et al. 2016).";
    }

    @Override
    public String settings() {
        return "seed " + seed + ", up to " + mostSamples + " samples, " + repeats + " runs, scenes " + sceneSettings;
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (ExactProblem problem : ExactProblem.values()) {
            methods.forEach((title, factory) -> exact.counts()
                    .forEach(samples -> trials.add(new Trial(
                            problem.key(),
                            title,
                            samples,
                            () -> exact.figures(problem::instance, problem.space(), factory, samples)))));
        }
        methods.forEach((title, factory) ->
                trials.add(new Trial(INDEPENDENCE, title, SAMPLES_OF_INDEPENDENCE, () -> independence(factory))));
        scenes.forEach((name, pixels) -> methods.forEach((title, factory) -> exact.counts()
                .forEach(samples ->
                        trials.add(new Trial(name, title, samples, () -> scene(pixels, factory, samples))))));
        return trials;
    }

    /**
     * Whether neighbouring pixels err independently: the variance of the mean error of pixels that see the same,
     * divided by what it is without any correlation. It is 1 for independent pixels and their number if all err alike.
     */
    private Figures independence(SamplingMethod.Factory factory) {
        int samples = SAMPLES_OF_INDEPENDENCE;
        SamplePattern pattern = factory.pattern(seed, samples, SampledSpace.LENS);
        double[] errors = exact.errors(ExactProblem.EDGE::instance, pattern, samples);
        double ofMeans = 0;
        double ofAll = 0;
        for (int i = 0; i < ExactTrials.INSTANCES; i++) {
            double mean = 0;
            for (int j = 0; j < ExactTrials.PIXELS_OF_INSTANCE; j++) {
                double error = errors[i * ExactTrials.PIXELS_OF_INSTANCE + j];
                mean += error / ExactTrials.PIXELS_OF_INSTANCE;
                ofAll += error * error / errors.length;
            }
            ofMeans += mean * mean / ExactTrials.INSTANCES;
        }
        return Figures.of(
                (double) samples * errors.length, Spread.exact(0), ofMeans / ofAll * ExactTrials.PIXELS_OF_INSTANCE);
    }

    private Figures scene(ScenePixels pixels, SamplingMethod.Factory factory, int samples) {
        if (samples <= 16) {
            Stopwatch.warmUp(() -> pixels.light(factory.pattern(0, samples, pixels.space()), samples));
        }
        List<SamplePattern> patterns = LongStream.range(seed, seed + SCENE_REPEATS)
                .mapToObj(run -> factory.pattern(run, samples, pixels.space()))
                .toList();
        return pixels.placed(patterns, samples);
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (ExactProblem problem : ExactProblem.values()) {
            charts.add(Chart.errorAgainstTime(problem.key(), problem.title() + ", exact answer")
                    .withOwn(program));
        }
        for (String name : scenes.keySet()) {
            charts.add(Chart.errorAgainstTime(name, name + ", wide aperture").withOwn(program));
        }
        return charts;
    }

    @Override
    public String answer(List<Measurement> all) {
        return findings.answer(all);
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        return findings.of(all);
    }
}
