package tompkins.study;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/**
 * What the measurements of {@link ApertureStudy} must show. The limits follow from theory: the error of independent
 * places falls as N^(-1/2), that of one place in each cell as N^(-3/4) at an edge (Mitchell 1996), and as N^(-5/8) if
 * the edge also sweeps over the pixel.
 */
final class ApertureFindings {

    private static final String RANDOM = SamplingMethod.RANDOM.title();
    private static final String SPIRAL = SamplingMethod.VOGEL.title();
    private static final double STEEP_ON_LENS = -0.70;
    private static final double STEEP_IN_PIXEL = -0.57;
    private static final double STRAIGHT = 0.98;
    private static final double COMPARED_AT = 256;
    private static final double MOST_CORRELATION = 2;

    private final Collection<String> methods;
    private final String program;
    private final Collection<String> scenes;

    ApertureFindings(Collection<String> methods, String program, Collection<String> scenes) {
        this.methods = methods;
        this.program = program;
        this.scenes = scenes;
    }

    List<Finding> of(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        for (ExactProblem problem : ExactProblem.values()) {
            slopes(problem, all, findings);
            advantage(problem, all, findings);
        }
        for (String scene : scenes) {
            scene(scene, all, findings);
        }
        findings.add(independence(all));
        return findings;
    }

    /** What the charts show. */
    String answer(List<Measurement> all) {
        PowerLaw random = law(ExactProblem.EDGE.key(), RANDOM, all);
        PowerLaw own = law(ExactProblem.EDGE.key(), program, all);
        PowerLaw ownWithPixel = law(ExactProblem.SWEEP.key(), program, all);
        PowerLaw spiralWithPixel = law(ExactProblem.SWEEP.key(), SPIRAL, all);
        String scene = scenes.iterator().next();
        return Finding.text(
                "Random places need four times as many samples for half the error. Places that keep their distance do better:"
                        + " at an edge the error of the program's points falls as the number of samples to the power %.2f, and"
                        + " an error of 0.002, half a step of an 8-bit picture, takes them %s samples where random places take"
                        + " %s.\n\n"
                        + "The charts show seconds, the table counts samples. On the lens alone the Vogel spiral"
                        + " needs %s samples for this error, and a point of it takes %.0f ns where one of the program takes %.0f ns,"
                        + " which is nearly all the time in problems that have a formula for an answer. In a photograph a ray is traced"
                        + " through each point: on %s a sample takes %.0f ns with the spiral and %.0f ns with"
                        + " the program's points. And the spiral fills the lens evenly, but not pixel and lens together, as every"
                        + " photograph with a wide aperture needs it: where the edge also sweeps over the pixel, its error falls with the"
                        + " number of samples to the power %.2f, that of the program's points to the power %.2f. So the program"
                        + " takes Sobol points with Owen's scrambling.",
                own.slope(),
                samplesFor(0.002, own),
                samplesFor(0.002, random),
                samplesFor(0.002, law(ExactProblem.EDGE.key(), SPIRAL, all)),
                nanosecondsOfSample(ExactProblem.EDGE.key(), SPIRAL, all),
                nanosecondsOfSample(ExactProblem.EDGE.key(), program, all),
                scene,
                nanosecondsOfSample(scene, SPIRAL, all),
                nanosecondsOfSample(scene, program, all),
                spiralWithPixel.slope(),
                ownWithPixel.slope());
    }

    /** The time of a sample where there are most of them. */
    private static double nanosecondsOfSample(String problem, String method, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem, method, all);
        Measurement most = points.get(points.size() - 1);
        return 1e9 * most.medianSeconds() / most.rays();
    }

    private static String samplesFor(double error, PowerLaw law) {
        double samples = Math.pow(error / law.factor(), 1 / law.slope());
        return new BigDecimal(samples).round(new MathContext(2)).toBigInteger().toString();
    }

    private void slopes(ExactProblem problem, List<Measurement> all, List<Finding> findings) {
        PowerLaw random = law(problem.key(), RANDOM, all);
        findings.add(Finding.of(
                random.slope() >= -0.55 && random.slope() <= -0.45,
                problem.title() + ": slope of random places",
                "-0.55 to -0.45 (theory: -1/2)",
                "%.3f",
                random.slope()));
        PowerLaw own = law(problem.key(), program, all);
        double steep = problem.space().hasPixel() ? STEEP_IN_PIXEL : STEEP_ON_LENS;
        findings.add(Finding.of(
                own.slope() <= steep && own.rSquared() > STRAIGHT,
                problem.title() + ": slope of the program's places",
                Finding.text(
                        "at most %.2f (theory: %s), R² above %.2f",
                        steep, problem.space().hasPixel() ? "-5/8" : "-3/4", STRAIGHT),
                "%.3f, R² = %.4f",
                own.slope(),
                own.rSquared()));
    }

    private void advantage(ExactProblem problem, List<Measurement> all, List<Finding> findings) {
        double limit = problem == ExactProblem.EDGE || problem == ExactProblem.DISC ? 0.25 : 0.5;
        double share = error(problem.key(), program, all) / error(problem.key(), RANDOM, all);
        findings.add(Finding.of(
                share <= limit,
                Finding.text(
                        "%s: error of the program's places with %.0f samples, divided by that of random ones",
                        problem.title(), COMPARED_AT),
                Finding.text("at most %.2f", limit),
                "%.3f",
                share));
    }

    private void scene(String scene, List<Measurement> all, List<Finding> findings) {
        double own = error(scene, program, all);
        String best = methods.stream()
                .min((a, b) -> Double.compare(error(scene, a, all), error(scene, b, all)))
                .orElse(program);
        double random = error(scene, RANDOM, all);
        findings.add(Finding.of(
                own <= 0.5 * random && own <= 1.25 * error(scene, best, all),
                Finding.text("%s: error of the program's places with %.0f samples", scene, COMPARED_AT),
                "at most half of random places and 1.25 times the best",
                "%.2g; random %.2g; the best (%s) %.2g",
                own,
                random,
                best,
                error(scene, best, all)));
    }

    private Finding independence(List<Measurement> all) {
        double ratio =
                Measurement.of(ApertureStudy.INDEPENDENCE, program, all).get(0).medianError();
        return Finding.of(
                ratio < MOST_CORRELATION,
                "Pixels that see the same err independently: variance of their mean error, divided by that of independent"
                        + " pixels",
                Finding.text("below %.0f (%d if all err alike)", MOST_CORRELATION, ExactTrials.PIXELS_OF_INSTANCE),
                "%.2f",
                ratio);
    }

    private static PowerLaw law(String problem, String method, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem, method, all).stream()
                .filter(point -> point.setting() >= 16)
                .toList();
        return PowerLaw.ofError(points, Measurement::setting);
    }

    private static double error(String problem, String method, List<Measurement> all) {
        return Measurement.of(problem, method, all).stream()
                .filter(point -> point.setting() <= COMPARED_AT)
                .reduce((first, second) -> second)
                .map(point -> point.medianError())
                .orElse(Double.NaN);
    }
}
