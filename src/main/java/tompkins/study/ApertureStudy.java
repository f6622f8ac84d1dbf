package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import tompkins.studio.Studio;

/** How best to choose places on the lens, and in the pixel. */
final class ApertureStudy implements Study {

    static final String INDEPENDENCE = "independence";

    private static final int SAMPLES_OF_INDEPENDENCE = 16;

    private final long seed;
    private final ExactTrials exact;
    private final MethodTrials trials;
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
        exact = new ExactTrials(seed, mostSamples, repeats);
        this.methods = methods;
        this.program = program;
        trials = new MethodTrials(studios, seed, mostSamples, repeats, methods);
        findings = new ApertureFindings(methods.keySet(), program, trials.scenes());
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
        return trials.settings();
    }

    @Override
    public List<Trial> trials() {
        List<Trial> all = new ArrayList<>();
        for (ExactProblem problem : ExactProblem.values()) {
            all.addAll(trials.onProblem(problem.key(), problem.space(), problem::instance));
        }
        methods.forEach((title, factory) ->
                all.add(new Trial(INDEPENDENCE, title, SAMPLES_OF_INDEPENDENCE, () -> independence(factory))));
        all.addAll(trials.onScenes());
        return all;
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

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (ExactProblem problem : ExactProblem.values()) {
            charts.add(Chart.errorAgainstTime(problem.key(), problem.title() + ", exact answer")
                    .withOwn(program));
        }
        for (String name : trials.scenes()) {
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
