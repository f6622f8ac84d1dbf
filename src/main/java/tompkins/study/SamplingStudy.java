package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import tompkins.io.BundledScenes;

/**
 * How best to spread the samples of a pixel: all methods at work on problems with an exact answer, where the number of
 * samples counts, and in photographs, where the time counts that they take on the way of the renderer.
 *
 * @param question the name of its texts
 * @param seed of everything that is random
 * @param mostSamples the largest number of samples per pixel; a power of 4
 * @param repeats runs of each trial with an exact answer
 * @param methods the methods, by name
 * @param problems those with an exact answer
 * @param scenes the photographs, by name
 */
record SamplingStudy(
        String question,
        long seed,
        int mostSamples,
        int repeats,
        Map<String, SamplingMethod.Factory> methods,
        List<ExactProblem> problems,
        Map<String, ScenePixels> scenes)
        implements Study {

    /** The method of Dr TIM. */
    static final String RANDOM = SamplingMethod.RANDOM.title();

    /** The program's own method. */
    static final String PROGRAM = SamplingMethod.SOBOL.title();

    private static final int MOST_SAMPLES = 4096;
    private static final int REPEATS = 5;
    private static final int SCENE_BLOCKS = 8;
    private static final int SCENE_REPEATS = 3;
    private static final double STRAIGHT = 0.98;
    private static final double COMPARED_AT = 256;

    /** How many times as long random places may at least take in a photograph as the program's. */
    private static final double FASTER = 4;

    /** The study of some bundled scenes and problems, as thorough as for the documents. */
    static SamplingStudy of(String question, long seed, List<ExactProblem> problems, String... scenes) {
        Map<String, ScenePixels> photographs = new LinkedHashMap<>();
        BundledScenes.named(scenes)
                .forEach((name, studio) -> photographs.put(
                        name,
                        new ScenePixels(
                                studio, SCENE_BLOCKS, 16 * MOST_SAMPLES, Double.POSITIVE_INFINITY, () -> false)));
        return new SamplingStudy(question, seed, MOST_SAMPLES, REPEATS, SamplingMethod.all(), problems, photographs);
    }

    @Override
    public String settings() {
        return StudyText.of("sampling.settings", seed, mostSamples, repeats, SCENE_BLOCKS, scenes.keySet());
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (ExactProblem problem : problems) {
            for (int samples : counts()) {
                methods.forEach((title, factory) ->
                        trials.add(new Trial(problem.key(), title, samples, () -> exact(problem, factory, samples))));
            }
        }
        scenes.forEach((name, pixels) -> counts().forEach(samples -> trials.addAll(race(name, pixels, samples))));
        return trials;
    }

    /** Numbers of samples that are measured. */
    private List<Integer> counts() {
        return IntStream.iterate(4, samples -> samples <= mostSamples, samples -> 4 * samples)
                .boxed()
                .toList();
    }

    /** All methods at work on a photograph, in turns. */
    private List<Trial> race(String name, ScenePixels pixels, int samples) {
        Map<String, IntFunction<Figures>> racers = new LinkedHashMap<>();
        methods.forEach((title, factory) -> racers.put(
                title, run -> pixels.sampled(factory.sampler(seed + run, samples, pixels.space()), samples)));
        return Race.trials(name, samples, racers, SCENE_REPEATS);
    }

    /** The errors of a method; its time is not asked, since a formula takes less than choosing the positions. */
    private Figures exact(ExactProblem problem, SamplingMethod.Factory factory, int samples) {
        return Figures.of(IntStream.rangeClosed(1, repeats)
                .mapToObj(run -> problem.errors(seed, factory.sampler(seed + run, samples, problem.space()), samples))
                .map(errors -> Figures.of((double) samples * errors.length, 0, errors, 0))
                .toList());
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (ExactProblem problem : problems) {
            String title = problem.title() + ", exact answer";
            charts.add(new Chart(problem.key(), title, Chart.setting("samples per pixel"), Chart.ERROR, true, PROGRAM));
        }
        for (String name : scenes.keySet()) {
            charts.add(Chart.errorAgainstTime(name, name + ", " + StudyText.of(question + ".photographs"), PROGRAM));
        }
        return charts;
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        conclusion.say(question + ".answer");
        for (ExactProblem problem : problems) {
            String slopes = methods.keySet().stream()
                    .map(method -> StudyText.format(
                            "%s %.2f", method, law(problem, method, all).slope()))
                    .collect(Collectors.joining(", "));
            conclusion.say("sampling.slopes", problem.title(), slopes);
            double random = law(problem, RANDOM, all).slope();
            conclusion.demand(random >= -0.55 && random <= -0.45, "sampling.random", problem.title(), random);
            PowerLaw own = law(problem, PROGRAM, all);
            conclusion.demand(
                    own.slope() <= problem.largestSlope() && own.rSquared() > STRAIGHT,
                    "sampling.program",
                    problem.title(),
                    problem.largestSlope(),
                    problem.theory(),
                    STRAIGHT,
                    own.slope(),
                    own.rSquared());
            double ratio = error(problem, PROGRAM, all) / error(problem, RANDOM, all);
            conclusion.demand(
                    ratio <= problem.ratio(), "sampling.share", problem.title(), COMPARED_AT, problem.ratio(), ratio);
        }
        scenes.keySet().forEach(scene -> conclude(scene, all, conclusion));
    }

    /** How soon the methods reach in a photograph what random places reach in the end. */
    private void conclude(String scene, List<StudyPoint> all, Conclusion conclusion) {
        List<StudyPoint> randoms = StudyPoint.of(scene, RANDOM, all);
        StudyPoint random = randoms.get(randoms.size() - 1);
        double error = random.medianError();
        String times = methods.keySet().stream()
                .filter(method -> Double.isFinite(secondsTo(error, scene, method, all)))
                .map(method -> StudyText.format("%s %.0f ms", method, 1e3 * secondsTo(error, scene, method, all)))
                .collect(Collectors.joining(", "));
        conclusion.say("sampling.times", error, scene, times);
        double gain = random.medianSeconds() / secondsTo(error, scene, PROGRAM, all);
        conclusion.demand(gain >= FASTER, "sampling.againstRandom", scene, error, FASTER, gain);
    }

    /** The time in which a method comes to an error, between its measurements; infinite if it does not. */
    private static double secondsTo(double error, String problem, String method, List<StudyPoint> all) {
        StudyPoint before = null;
        for (StudyPoint point : StudyPoint.of(problem, method, all)) {
            if (point.medianError() <= error) {
                return before == null ? point.medianSeconds() : between(before, point, error);
            }
            before = point;
        }
        return Double.POSITIVE_INFINITY;
    }

    /** The time at an error, on the straight line between two points of a logarithmic chart. */
    private static double between(StudyPoint before, StudyPoint after, double error) {
        double part = Math.log(before.medianError() / error) / Math.log(before.medianError() / after.medianError());
        return before.medianSeconds() * Math.pow(after.medianSeconds() / before.medianSeconds(), part);
    }

    private static double error(ExactProblem problem, String method, List<StudyPoint> all) {
        return StudyPoint.of(problem.key(), method, COMPARED_AT, all).medianError();
    }

    /** How the error of a method falls with the number of samples. */
    static PowerLaw law(ExactProblem problem, String method, List<StudyPoint> all) {
        List<StudyPoint> points = StudyPoint.of(problem.key(), method, all).stream()
                .filter(point -> point.setting() >= 16)
                .toList();
        return PowerLaw.ofError(points, StudyPoint::setting);
    }
}
