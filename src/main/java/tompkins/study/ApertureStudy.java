package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import tompkins.studio.Studio;
import tompkins.study.ExactProblem.Instance;

/** How best to choose places on the lens, and in the pixel. */
final class ApertureStudy implements Study {

    static final String INDEPENDENCE = "independence";

    private static final int INSTANCES = 60;

    /** The pixels of an instance form a square, so that neighbours in either direction are compared. */
    private static final int SIDE_OF_INSTANCE = 4;

    static final int PIXELS_OF_INSTANCE = SIDE_OF_INSTANCE * SIDE_OF_INSTANCE;
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
        studios.forEach((name, studio) -> scenes.put(name, new ScenePixels(studio, SCENE_PIXELS, 16 * mostSamples)));
        findings = new ApertureFindings(methods.keySet(), program, scenes.keySet());
    }

    @Override
    public String name() {
        return "aperture";
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
            methods.forEach((title, factory) -> {
                for (int samples = 4; samples <= mostSamples; samples *= 4) {
                    int count = samples;
                    trials.add(new Trial(
                            problem.key(),
                            title,
                            count,
                            cancelled -> exact(problem, title, factory, count, cancelled)));
                }
            });
        }
        methods.forEach((title, factory) ->
                trials.add(new Trial(INDEPENDENCE, title, 16, cancelled -> independence(title, factory))));
        scenes.forEach((name, pixels) -> methods.forEach((title, factory) -> {
            for (int samples = 4; samples <= mostSamples; samples *= 4) {
                int count = samples;
                trials.add(new Trial(
                        name, title, count, cancelled -> scene(name, pixels, title, factory, count, cancelled)));
            }
        }));
        return trials;
    }

    private Measurement exact(
            ExactProblem problem,
            String title,
            SamplingMethod.Factory factory,
            int samples,
            BooleanSupplier cancelled) {
        Repeats runs = new Repeats();
        double[] errors = new double[INSTANCES * PIXELS_OF_INSTANCE];
        Stopwatch.warmUp(
                () -> errors(problem, factory.pattern(0, samples, problem.pixelToo()), samples, errors), cancelled);
        for (int run = 0; run < repeats; run++) {
            Stopwatch.stopIf(cancelled);
            SamplePattern pattern = factory.pattern(seed + run, samples, problem.pixelToo());
            double time = Stopwatch.seconds(() -> errors(problem, pattern, samples, errors));
            runs.add(ErrorNorm.of(errors), time);
        }
        return runs.measurement(problem.key(), title, samples, (double) samples * errors.length, 0);
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
     * Whether neighbouring pixels err independently: the variance of the mean error of pixels that see the same, divided by
     * what it is without any correlation. It is 1 for independent pixels and their number if all err alike.
     */
    private Measurement independence(String title, SamplingMethod.Factory factory) {
        int samples = 16;
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
        Spread ratio = Spread.exact(ofMeans / ofAll * PIXELS_OF_INSTANCE);
        return new Measurement(
                INDEPENDENCE,
                title,
                samples,
                (double) samples * errors.length,
                Spread.exact(0),
                ratio,
                ratio.middle(),
                0);
    }

    private Measurement scene(
            String name,
            ScenePixels pixels,
            String title,
            SamplingMethod.Factory factory,
            int samples,
            BooleanSupplier cancelled) {
        double[] reference = pixels.reference(cancelled);
        Repeats runs = new Repeats();
        if (samples <= 16) {
            Stopwatch.warmUp(() -> pixels.light(factory.pattern(0, samples, true), samples, cancelled), cancelled);
        }
        for (int run = 0; run < SCENE_REPEATS; run++) {
            SamplePattern pattern = factory.pattern(seed + run, samples, true);
            long start = System.nanoTime();
            double[] light = pixels.light(pattern, samples, cancelled);
            runs.add(ErrorNorm.of(light, reference), (System.nanoTime() - start) / 1e9);
        }
        return runs.measurement(name, title, samples, (double) samples * pixels.count(), pixels.floor());
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
