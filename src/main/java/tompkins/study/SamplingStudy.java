package tompkins.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import tompkins.studio.Studio;

/**
 * How best to spread the samples of a pixel: all methods at work on problems with an exact answer, where the number of
 * samples counts, and in photographs, where the time counts that they take on the way of the renderer.
 */
abstract class SamplingStudy implements Study {

    /** The method of Dr TIM. */
    static final String RANDOM = SamplingMethod.RANDOM.title();

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
     * @param program the name of the program's own method
     */
    record Comparison(
            long seed, int mostSamples, int repeats, Map<String, SamplingMethod.Factory> methods, String program) {}

    private final Comparison comparison;
    private final Map<String, SamplingMethod.Factory> methods;
    private final String program;
    private final List<ExactProblem> problems;
    private final String photographed;
    private final Map<String, ScenePixels> scenes = new LinkedHashMap<>();
    private final String sceneNames;

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
        methods = comparison.methods;
        program = comparison.program;
        sceneNames = StudySetup.settings(studios);
        int referenceSamples = 16 * comparison.mostSamples;
        studios.forEach((name, studio) -> scenes.put(
                name, new ScenePixels(studio, SCENE_BLOCKS, referenceSamples, Double.POSITIVE_INFINITY, () -> false)));
    }

    final Comparison comparison() {
        return comparison;
    }

    @Override
    public final String settings() {
        return "seed " + comparison.seed + ", up to " + comparison.mostSamples + " samples, " + comparison.repeats
                + " runs, " + SCENE_BLOCKS
                + " blocks of photographs, times of the processor, scenes " + sceneNames;
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
        methods.forEach((title, factory) -> racers.put(
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
            charts.add(new Chart(
                            problem.key(),
                            problem.title() + ", exact answer",
                            Chart.setting("samples per pixel"),
                            Chart.ERROR,
                            true)
                    .withOwn(program));
        }
        for (String name : scenes.keySet()) {
            charts.add(Chart.errorAgainstTime(name, name + ", " + photographed).withOwn(program));
        }
        return charts;
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (ExactProblem problem : problems) {
            PowerLaw random = law(problem, RANDOM, all);
            findings.add(Finding.of(
                    random.slope() >= -0.55 && random.slope() <= -0.45,
                    problem.title() + ": slope of random places",
                    "-0.55 to -0.45 (theory: -1/2)",
                    "%.3f",
                    random.slope()));
            PowerLaw own = law(problem, program, all);
            findings.add(Finding.of(
                    own.slope() <= problem.largestSlope() && own.rSquared() > STRAIGHT,
                    problem.title() + ": slope of the program's places",
                    Finding.text(
                            "at most %.2f (theory: %s), R² above %.2f",
                            problem.largestSlope(), problem.theory(), STRAIGHT),
                    "%.3f, R² = %.4f",
                    own.slope(),
                    own.rSquared()));
            double share = shareOfRandom(problem, all);
            findings.add(Finding.of(
                    share <= problem.share(),
                    Finding.text(
                            "%s: error of the program's places with %.0f samples, divided by that of random ones",
                            problem.title(), COMPARED_AT),
                    Finding.text("at most %.2f", problem.share()),
                    "%.3f",
                    share));
        }
        for (String scene : scenes.keySet()) {
            findings.add(againstRandom(scene, all));
            findings.add(againstFastest(scene, all));
        }
        return findings;
    }

    /** How soon the program reaches what random places reach in the end. */
    private Finding againstRandom(String scene, List<Measurement> all) {
        Measurement random = last(scene, RANDOM, all);
        double own = secondsTo(random.medianError(), scene, program, all);
        return Finding.of(
                own * FASTER <= random.medianSeconds(),
                Finding.text("%s: time of random places for an RMS error of %.2g", scene, random.medianError()),
                Finding.text("at least %.0f times that of the program's", FASTER),
                "%.1f times",
                random.medianSeconds() / own);
    }

    /** How soon the program reaches a small error, compared with the fastest method. */
    private Finding againstFastest(String scene, List<Measurement> all) {
        Measurement own = lastButOne(scene, program, all);
        double error = own.medianError();
        String fastest = methods.keySet().stream()
                .min(Comparator.comparingDouble(method -> secondsTo(error, scene, method, all)))
                .orElse(program);
        double ratio = own.medianSeconds() / secondsTo(error, scene, fastest, all);
        return Finding.of(
                ratio <= SLOWER,
                Finding.text("%s: time of the program's places for an RMS error of %.2g", scene, error),
                Finding.text("at most %.2f times that of the fastest method", SLOWER),
                "%.2f times (%s)",
                ratio,
                fastest);
    }

    /** What each photograph says about the time of the methods, beginning with a space. */
    final String timesInPhotographs(List<Measurement> all) {
        StringBuilder text = new StringBuilder();
        for (String scene : scenes.keySet()) {
            for (Measurement goal : List.of(last(scene, RANDOM, all), lastButOne(scene, program, all))) {
                double error = goal.medianError();
                List<String> times = methods.keySet().stream()
                        .filter(method -> Double.isFinite(secondsTo(error, scene, method, all)))
                        .sorted(Comparator.comparingDouble(method -> secondsTo(error, scene, method, all)))
                        .map(method -> Finding.text("%s %.0f ms", method, 1e3 * secondsTo(error, scene, method, all)))
                        .toList();
                text.append(Finding.text(
                        " For an RMS error of %.2g, %s takes: %s.", error, scene, String.join(", ", times)));
            }
        }
        return text.toString();
    }

    /** The measurement with the most samples. */
    private static Measurement last(String problem, String method, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem, method, all);
        return points.get(points.size() - 1);
    }

    /** The same with a quarter of the samples, an error that other methods reach, too. */
    private static Measurement lastButOne(String problem, String method, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem, method, all);
        return points.get(Math.max(0, points.size() - 2));
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
        return error(problem, program, all) / error(problem, RANDOM, all);
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
