package tompkins.study;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * What the measurements of {@link ApertureStudy} must show. The limits follow from theory: independent places err as
 * N^(-1/2); one place in each cell as N^(-3/4) at an edge (Mitchell 1996), and as N^(-5/8) where the edge also sweeps over
 * the pixel.
 */
final class ApertureFindings {

    private static final double STEEP_ON_LENS = -0.70;
    private static final double STEEP_IN_PIXEL = -0.57;
    private static final double STRAIGHT = 0.98;
    private static final double COMPARED_AT = 256;

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

    private void slopes(ExactProblem problem, List<Measurement> all, List<Finding> findings) {
        String list = methods.stream()
                .map(method -> String.format(
                        Locale.ROOT,
                        "%s %.2f",
                        method,
                        law(problem.key(), method, all).slope()))
                .collect(Collectors.joining(", "));
        findings.add(Finding.note(
                "%s: the error falls with these powers of the number of samples: %s.", problem.title(), list));
        PowerLaw random = law(problem.key(), SamplingMethod.RANDOM.title(), all);
        findings.add(Finding.check(
                random.slope() >= -0.55 && random.slope() <= -0.45,
                "%s: random places must fall with power -1/2, and do with %.3f.",
                problem.title(),
                random.slope()));
        PowerLaw own = law(problem.key(), program, all);
        double steep = problem.pixelToo() ? STEEP_IN_PIXEL : STEEP_ON_LENS;
        findings.add(Finding.check(
                own.slope() <= steep && own.rSquared() > STRAIGHT,
                "%s: the program's sampler must fall with power %.2f or steeper on a straight line, and does with %.3f"
                        + " (R² = %.4f).",
                problem.title(),
                steep,
                own.slope(),
                own.rSquared()));
    }

    private void advantage(ExactProblem problem, List<Measurement> all, List<Finding> findings) {
        double limit = problem == ExactProblem.EDGE || problem == ExactProblem.DISC ? 0.25 : 0.5;
        double share = error(problem.key(), program, all) / error(problem.key(), SamplingMethod.RANDOM.title(), all);
        findings.add(Finding.check(
                share <= limit,
                "%s: with %.0f samples the program's sampler errs %.2f times as much as random places; at most %.2f is"
                        + " allowed.",
                problem.title(),
                COMPARED_AT,
                share,
                limit));
    }

    private void scene(String scene, List<Measurement> all, List<Finding> findings) {
        double own = error(scene, program, all);
        String best = methods.stream()
                .min((a, b) -> Double.compare(error(scene, a, all), error(scene, b, all)))
                .orElse(program);
        double random = error(scene, SamplingMethod.RANDOM.title(), all);
        findings.add(Finding.check(
                own <= 0.5 * random && own <= 1.25 * error(scene, best, all),
                "%s, %.0f samples: random places err by %.2g, the program's sampler by %.2g, the best (%s) by %.2g; the"
                        + " program's must be within a quarter of the best.",
                scene,
                COMPARED_AT,
                random,
                own,
                best,
                error(scene, best, all)));
    }

    private Finding independence(List<Measurement> all) {
        double ratio =
                points(ApertureStudy.INDEPENDENCE, program, all).get(0).error().middle();
        return Finding.check(
                ratio < 3,
                "Pixels that see the same must not err alike: their mean error varies %.2f times as much as that of"
                        + " independent pixels (10 times if all erred alike; below 3 is allowed).",
                ratio);
    }

    private static PowerLaw law(String problem, String method, List<Measurement> all) {
        List<Measurement> points = points(problem, method, all).stream()
                .filter(point -> point.setting() >= 16)
                .toList();
        return PowerLaw.ofError(points, Measurement::setting);
    }

    private static double error(String problem, String method, List<Measurement> all) {
        return points(problem, method, all).stream()
                .filter(point -> point.setting() <= COMPARED_AT)
                .reduce((first, second) -> second)
                .map(point -> point.error().middle())
                .orElse(Double.NaN);
    }

    private static List<Measurement> points(String problem, String method, List<Measurement> all) {
        return all.stream()
                .filter(point -> point.problem().equals(problem))
                .filter(point -> point.method().equals(method))
                .toList();
    }
}
