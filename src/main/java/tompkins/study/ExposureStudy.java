package tompkins.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import tompkins.studio.Studio;

/** How best to choose the moments of samples while the shutter stays open. */
final class ExposureStudy implements Study {

    private static final double STRAIGHT = 0.98;
    private static final int COMPARED_AT = 256;
    private static final double SHARE_OF_RANDOM = 0.4;
    private static final String RANDOM = SamplingMethod.RANDOM.title();

    private final MethodTrials trials;
    private final String program;

    /**
     * The study.
     *
     * @param studios photographs with an exposure time, to be measured beside the problems with an exact answer, by
     *     name
     * @param mostSamples the largest number of samples per pixel; a power of 4
     * @param repeats runs of each trial with an exact answer
     * @param methods the methods, by name
     * @param program the name of the program's own method
     */
    ExposureStudy(
            Map<String, Studio> studios,
            long seed,
            int mostSamples,
            int repeats,
            Map<String, SamplingMethod.Factory> methods,
            String program) {
        this.program = program;
        trials = new MethodTrials(studios, seed, mostSamples, repeats, methods);
    }

    @Override
    public String question() {
        return "While the shutter stays open, each sample of a pixel has a moment of its own. How should the moments be"
                + " chosen, beside the places in the pixel? Each method works out for how much of the exposure a pixel sees a"
                + " bright edge, slit or disc in uniform motion, where the answer is known exactly, and the light of pixels of"
                + " photographs with a long exposure.";
    }

    @Override
    public String settings() {
        return trials.settings();
    }

    @Override
    public List<Trial> trials() {
        List<Trial> all = new ArrayList<>();
        for (MotionProblem problem : MotionProblem.values()) {
            all.addAll(trials.onProblem(problem.key(), SampledSpace.TIME_AND_PIXEL, problem::instance));
        }
        all.addAll(trials.onScenes());
        return all;
    }

    @Override
    public List<Chart> charts() {
        List<Chart> charts = new ArrayList<>();
        for (MotionProblem problem : MotionProblem.values()) {
            // a formula takes less time than choosing the places: what counts is how many samples a picture needs
            charts.add(new Chart(
                            problem.key(),
                            problem.title() + ", exact answer",
                            Chart.setting("samples per pixel"),
                            Chart.ERROR,
                            true)
                    .withOwn(program));
        }
        for (String name : trials.scenes()) {
            charts.add(Chart.errorAgainstTime(name, name + ", long exposure").withOwn(program));
        }
        return charts;
    }

    @Override
    public String answer(List<Measurement> all) {
        return Finding.text(
                "Time is one more dimension of the program's Sobol points; a pinhole gives it the first, an aperture the fourth."
                        + " At an edge that passes along rows or columns the error falls as the number of samples to the power"
                        + " %.2f, as it does at an edge in a wide aperture, and at a slanted one to the power %.2f: pixel and time"
                        + " have three dimensions, and places in three dimensions cannot do better than -2/3 for edges in all"
                        + " directions. Random moments keep to -1/2. With %d samples the program's points err by %.2f times what"
                        + " random ones do at the edge, and by %.2f times that at the slit.",
                law(MotionProblem.EDGE, program, all).slope(),
                law(MotionProblem.SLANTED, program, all).slope(),
                COMPARED_AT,
                shareOfRandom(MotionProblem.EDGE.key(), all),
                shareOfRandom(MotionProblem.SLIT.key(), all));
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (MotionProblem problem : MotionProblem.values()) {
            PowerLaw random = law(problem, RANDOM, all);
            findings.add(Finding.of(
                    random.slope() >= -0.55 && random.slope() <= -0.45,
                    problem.title() + ": slope of random moments and places",
                    "-0.55 to -0.45 (theory: -1/2)",
                    "%.3f",
                    random.slope()));
            PowerLaw own = law(problem, program, all);
            findings.add(Finding.of(
                    own.slope() <= problem.largestSlope() && own.rSquared() > STRAIGHT,
                    problem.title() + ": slope of the program's moments and places",
                    Finding.text(
                            "at most %.2f (theory: %s), R² above %.2f",
                            problem.largestSlope(), problem.theory(), STRAIGHT),
                    "%.3f, R² = %.4f",
                    own.slope(),
                    own.rSquared()));
            findings.add(advantage(problem.key(), problem.title(), all));
        }
        trials.scenes().forEach(name -> findings.add(advantage(name, name, all)));
        return findings;
    }

    private Finding advantage(String problem, String title, List<Measurement> all) {
        double share = shareOfRandom(problem, all);
        return Finding.of(
                share <= SHARE_OF_RANDOM,
                Finding.text(
                        "%s: error of the program's samples, %d of them, divided by that of random ones",
                        title, COMPARED_AT),
                Finding.text("at most %.2f", SHARE_OF_RANDOM),
                "%.3f",
                share);
    }

    private double shareOfRandom(String problem, List<Measurement> all) {
        return error(problem, program, all) / error(problem, RANDOM, all);
    }

    private static PowerLaw law(MotionProblem problem, String method, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem.key(), method, all).stream()
                .filter(point -> point.setting() >= 16)
                .toList();
        return PowerLaw.ofError(points, Measurement::setting);
    }

    private static double error(String problem, String method, List<Measurement> all) {
        return Measurement.of(problem, method, all).stream()
                .filter(point -> point.setting() == COMPARED_AT)
                .findFirst()
                .map(Measurement::medianError)
                .orElse(Double.NaN);
    }
}
