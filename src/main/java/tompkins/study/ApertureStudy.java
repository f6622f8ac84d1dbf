package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import tompkins.studio.Studio;
import tompkins.study.ExactProblem.Instance;

/** How best to choose places on the lens, and in the pixel. */
final class ApertureStudy implements Study {

    static final String INDEPENDENCE = "independence";

    private static final int INSTANCES = 60;

    /** The pixels of an instance form a square, so that neighbours in either direction are compared. */
    private static final int SIDE_OF_INSTANCE = 4;

    static final int PIXELS_OF_INSTANCE = SIDE_OF_INSTANCE * SIDE_OF_INSTANCE;
    private static final int SAMPLES_OF_INDEPENDENCE = 16;
    private static final int SCENE_PIXELS = 768;
    private static final int SCENE_REPEATS = 3;

    private final long seed;
    private final int mostSamples;
    private final int repeats;
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
            methods.forEach((title, factory) -> counts().forEach(samples ->
                    trials.add(new Trial(problem.key(), title, samples, () -> exact(problem, factory, samples)))));
        }
        methods.forEach((title, factory) ->
                trials.add(new Trial(INDEPENDENCE, title, SAMPLES_OF_INDEPENDENCE, () -> independence(factory))));
        scenes.forEach((name, pixels) -> methods.forEach((title, factory) -> counts().forEach(samples ->
                trials.add(new Trial(name, title, samples, () -> scene(pixels, factory, samples))))));
        return trials;
    }

    /** Numbers of samples that are measured. */
    private IntStream counts() {
        return IntStream.iterate(4, samples -> samples <= mostSamples, samples -> 4 * samples);
    }

    private Figures exact(ExactProblem problem, SamplingMethod.Factory factory, int samples) {
        double[] errors = new double[INSTANCES * PIXELS_OF_INSTANCE];
        Stopwatch.warmUp(() -> errors(problem, factory.pattern(0, samples, problem.pixelToo()), samples, errors));
        List<Figures> runs = new ArrayList<>();
        for (int run = 0; run < repeats; run++) {
            SamplePattern pattern = factory.pattern(seed + run, samples, problem.pixelToo());
            double seconds = Stopwatch.seconds(() -> errors(problem, pattern, samples, errors));
            runs.add(Figures.of((double) samples * errors.length, seconds, ErrorNorm.of(errors), 0));
        }
        return Figures.of(runs);
    }

    /** The errors of all pixels; those of one instance stand together. */
    private void errors(ExactProblem problem, SamplePattern pattern, int samples, double[] errors) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < INSTANCES; i++) {
            Instance instance = problem.instance(random);
            for (int j = 0; j < PIXELS_OF_INSTANCE; j++) {
                pattern.startPixel(j % SIDE_OF_INSTANCE, i * SIDE_OF_INSTANCE + j / SIDE_OF_INSTANCE);
                double sum = 0;
                double weights = 0;
                for (int sample = 0; sample < samples; sample++) {
                    pattern.goTo(sample);
                    sum += pattern.weight * instance.integrand().value(pattern);
                    weights += pattern.weight;
                }
                errors[i * PIXELS_OF_INSTANCE + j] = sum / weights - instance.exact();
            }
        }
    }

    /**
     * Whether neighbouring pixels err independently: the variance of the mean error of pixels that see the same,
     * divided by what it is without any correlation. It is 1 for independent pixels and their number if all err alike.
     */
    private Figures independence(SamplingMethod.Factory factory) {
        int samples = SAMPLES_OF_INDEPENDENCE;
        double[] errors = new double[INSTANCES * PIXELS_OF_INSTANCE];
        errors(ExactProblem.EDGE, factory.pattern(seed, samples, false), samples, errors);
        double ofMeans = 0;
        double ofAll = 0;
        for (int i = 0; i < INSTANCES; i++) {
            double mean = 0;
            for (int j = 0; j < PIXELS_OF_INSTANCE; j++) {
                double error = errors[i * PIXELS_OF_INSTANCE + j];
                mean += error / PIXELS_OF_INSTANCE;
                ofAll += error * error / errors.length;
            }
            ofMeans += mean * mean / INSTANCES;
        }
        return Figures.of((double) samples * errors.length, Spread.exact(0), ofMeans / ofAll * PIXELS_OF_INSTANCE);
    }

    private Figures scene(ScenePixels pixels, SamplingMethod.Factory factory, int samples) {
        if (samples <= 16) {
            Stopwatch.warmUp(() -> pixels.light(factory.pattern(0, samples, true), samples));
        }
        List<SamplePattern> patterns = LongStream.range(seed, seed + SCENE_REPEATS)
                .mapToObj(run -> factory.pattern(run, samples, true))
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
