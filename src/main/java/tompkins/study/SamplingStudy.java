package tompkins.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import tompkins.studio.Studio;

/**
 * How best to spread the samples of a pixel: all methods at work on problems with an exact answer, where the number of
 * samples counts, and in photographs, where the time counts that they take on the way of the renderer.
 */
abstract class SamplingStudy implements Study {

    /** The method of Dr TIM. */
    static final String RANDOM = SamplingMethod.RANDOM.title();

    /** The program's own method. */
    static final String PROGRAM = SamplingMethod.SOBOL.title();

    private static final int SCENE_BLOCKS = 8;
    private static final int SCENE_REPEATS = 3;
    private static final double STRAIGHT = 0.98;
    private static final double COMPARED_AT = 256;

    /** How many times as long random places may at least take in a photograph as the program's. */
    private static final double FASTER = 4;

    /** How many times the time of the fastest method the program's may take in a photograph. */
    private static final double SLOWER = 1.25;

    /**
     * What is compared, and how thoroughly.
     *
     * @param seed of everything that is random
     * @param mostSamples the largest number of samples per pixel; a power of 4
     * @param repeats runs of each trial with an exact answer
     * @param methods the methods, by name
     */
    record Comparison(long seed, int mostSamples, int repeats, Map<String, SamplingMethod.Factory> methods) {}

    private final Comparison comparison;
    private final List<ExactProblem> problems;
    private final String photographed;
    private final Map<String, ScenePixels> scenes = new LinkedHashMap<>();

    /**
     * The study.
     *
     * @param studios the photographs, by name
     * @param problems those with an exact answer
     * @param photographed what is special about the photographs
     */
    SamplingStudy(
            Map<String, Studio> studios, Comparison comparison, List<ExactProblem> problems, String photographed) {
        this.comparison = comparison;
        this.problems = problems;
        this.photographed = photographed;
        int referenceSamples = 16 * comparison.mostSamples;
        studios.forEach((name, studio) -> scenes.put(
                name, new ScenePixels(studio, SCENE_BLOCKS, referenceSamples, Double.POSITIVE_INFINITY, () -> false)));
    }

    final Comparison comparison() {
        return comparison;
    }

    @Override
    public final String settings() {
        return StudyText.of(
                "sampling.settings",
                comparison.seed,
                comparison.mostSamples,
                comparison.repeats,
                SCENE_BLOCKS,
                scenes.keySet());
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (ExactProblem problem : problems) {
            for (int samples : counts()) {
                comparison.methods.forEach((title, factory) ->
                        trials.add(new Trial(problem.key(), title, samples, () -> exact(problem, factory, samples))));
            }
        }
        scenes.forEach((name, pixels) -> {
            for (int samples : counts()) {
                trials.addAll(race(pixels, samples).trials(name, samples));
            }
        });
        return trials;
    }

    /** Numbers of samples that are measured. */
    private List<Integer> counts() {
        List<Integer> counts = new ArrayList<>();
        for (int samples = 4; samples <= comparison.mostSamples; samples *= 4) {
            counts.add(samples);
        }
        return counts;
    }

    /** All methods at work on a photograph, in turns. */
    private Race race(ScenePixels pixels, int samples) {
        Map<String, IntFunction<Figures>> racers = new LinkedHashMap<>();
        comparison.methods.forEach((title, factory) -> racers.put(
                title,
                run -> pixels.sampled(factory.sampler(comparison.seed + run, samples, pixels.space()), samples)));
        return new Race(racers, SCENE_REPEATS);
    }

    /** The errors of a method; its time is not asked, since a formula takes less than choosing the positions. */
    private Figures exact(ExactProblem problem, SamplingMethod.Factory factory, int samples) {
        return Figures.of(IntStream.rangeClosed(1, comparison.repeats)
                .mapToObj(run -> problem.errors(
                        comparison.seed, factory.sampler(comparison.seed + run, samples, problem.space()), samples))
                .map(errors -> Figures.of((double) samples * errors.length, 0, ErrorNorm.of(errors), 0))
                .toList());
    }

    @Override
    public final List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (ExactProblem problem : problems) {
            String title = problem.title() + ", exact answer";
            charts.add(new Chart(problem.key(), title, Chart.setting("samples per pixel"), Chart.ERROR, true, PROGRAM));
        }
        for (String name : scenes.keySet()) {
            charts.add(Chart.errorAgainstTime(name, name + ", " + photographed, PROGRAM));
        }
        return charts;
    }

    @Override
    public void conclude(List<Measurement> all, Conclusion conclusion) {
        for (ExactProblem problem : problems) {
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
            double share = shareOfRandom(problem, all);
            conclusion.demand(
                    share <= problem.share(), "sampling.share", problem.title(), COMPARED_AT, problem.share(), share);
        }
        scenes.keySet().forEach(scene -> conclude(scene, all, conclusion));
    }

    /** How soon the methods reach what random places reach in the end, and an error that all but they reach. */
    private void conclude(String scene, List<Measurement> all, Conclusion conclusion) {
        List<Measurement> randoms = Measurement.of(scene, RANDOM, all);
        Measurement random = randoms.get(randoms.size() - 1);
        double soon = saySecondsTo(random.medianError(), scene, all, conclusion).get(PROGRAM);
        conclusion.demand(
                soon * FASTER <= random.medianSeconds(),
                "sampling.againstRandom",
                scene,
                random.medianError(),
                FASTER,
                random.medianSeconds() / soon);
        List<Measurement> owns = Measurement.of(scene, PROGRAM, all);
        Measurement own = owns.get(Math.max(0, owns.size() - 2));
        Map.Entry<String, Double> fastest = saySecondsTo(own.medianError(), scene, all, conclusion)
                .entrySet()
                .iterator()
                .next();
        double ratio = own.medianSeconds() / fastest.getValue();
        conclusion.demand(
                ratio <= SLOWER, "sampling.againstFastest", scene, own.medianError(), SLOWER, ratio, fastest.getKey());
    }

    /** Says in which time each method comes to an error in a photograph, and returns the seconds, the fewest first. */
    private Map<String, Double> saySecondsTo(double error, String scene, List<Measurement> all, Conclusion conclusion) {
        Map<String, Double> seconds = new LinkedHashMap<>();
        comparison.methods.keySet().stream()
                .sorted(Comparator.comparingDouble(method -> secondsTo(error, scene, method, all)))
                .forEach(method -> seconds.put(method, secondsTo(error, scene, method, all)));
        String times = seconds.entrySet().stream()
                .filter(entry -> Double.isFinite(entry.getValue()))
                .map(entry -> StudyText.format("%s %.0f ms", entry.getKey(), 1e3 * entry.getValue()))
                .collect(Collectors.joining(", "));
        conclusion.say("sampling.times", error, scene, times);
        return seconds;
    }

    /** The time in which a method comes to an error, between its measurements; infinite if it does not. */
    private static double secondsTo(double error, String problem, String method, List<Measurement> all) {
        Measurement before = null;
        for (Measurement point : Measurement.of(problem, method, all)) {
            if (point.medianError() <= error) {
                return before == null ? point.medianSeconds() : between(before, point, error);
            }
            before = point;
        }
        return Double.POSITIVE_INFINITY;
    }

    /** The time at an error, on the straight line between two points of a logarithmic chart. */
    private static double between(Measurement before, Measurement after, double error) {
        double part = Math.log(before.medianError() / error) / Math.log(before.medianError() / after.medianError());
        return before.medianSeconds() * Math.pow(after.medianSeconds() / before.medianSeconds(), part);
    }

    final double shareOfRandom(ExactProblem problem, List<Measurement> all) {
        return error(problem, PROGRAM, all) / error(problem, RANDOM, all);
    }

    private static double error(ExactProblem problem, String method, List<Measurement> all) {
        return Measurement.of(problem.key(), method, all).stream()
                .filter(point -> point.setting() <= COMPARED_AT)
                .reduce((first, second) -> second)
                .map(Measurement::medianError)
                .orElse(Double.NaN);
    }

    /** How the error of a method falls with the number of samples. */
    static PowerLaw law(ExactProblem problem, String method, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem.key(), method, all).stream()
                .filter(point -> point.setting() >= 16)
                .toList();
        return PowerLaw.ofError(points, Measurement::setting);
    }
}
