package tompkins.study;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/** How exact the forms of the transformation are, up to the highest speeds. */
final class PrecisionStudy implements Study {

    static final String RADIANS = "radians";
    static final String PIXELS = "pixels";

    private static final MathContext DIGITS = new MathContext(50);
    private static final int DIRECTIONS = 400;
    private static final int TIMED = 200_000;
    private static final double FLOAT_ROUNDING = 0x1p-24;
    private static final double PIXEL = Math.toRadians(20) / 640;

    /** The gamma at which single precision is compared with the program. */
    private static final double TIMED_AT = 1e4;

    private static final double[] GAMMAS = {1.01, 3, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

    private static final Vector3dc AXIS = new Vector3d(0.2, -0.1, 0.97).normalize();

    /** Directions, and the exact answer to each. */
    private record Turned(Vector3d[] directions, BigDecimal[][] exact) {}

    private final long seed;

    /** The directions of each gamma. */
    private final Map<Double, Turned> known = new HashMap<>();

    PrecisionStudy(long seed) {
        this.seed = seed;
    }

    @Override
    public String settings() {
        return "seed " + seed + ", " + DIRECTIONS + " directions, pixels of a picture 20 degrees and 640 pixels wide";
    }

    @Override
    public List<Trial> trials() {
        List<Trial> trials = new ArrayList<>();
        for (String problem : List.of(RADIANS, PIXELS)) {
            for (DirectionForm form : DirectionForm.values()) {
                for (double gamma : GAMMAS) {
                    trials.add(new Trial(problem, form.title(), gamma, () -> measure(problem, form, gamma)));
                }
            }
        }
        return trials;
    }

    private Figures measure(String problem, DirectionForm form, double gamma) {
        Turned turned = known.computeIfAbsent(gamma, this::turned);
        DirectionForm.Direction turning = form.of(velocity(gamma));
        double[] errors = new double[DIRECTIONS];
        Vector3d found = new Vector3d();
        for (int i = 0; i < DIRECTIONS; i++) {
            turning.turn(turned.directions[i], found);
            BigDecimal[] exact = turned.exact[i];
            double error = angle(exact, found);
            // a picture shows the error where the Doppler factor shrinks or stretches it
            errors[i] = problem.equals(RADIANS) ? error : error * exact[3].doubleValue() / PIXEL;
        }
        // the time is the same at every speed, and for both problems
        boolean isTimed = problem.equals(PIXELS) && gamma == TIMED_AT;
        double seconds = isTimed ? seconds(() -> turnAll(turning, turned.directions, found)) : 0;
        return Figures.of(TIMED, Spread.exact(seconds), ErrorNorm.of(errors).maximum());
    }

    private static Velocity velocity(double gamma) {
        return Velocity.of(SpeedScale.GAMMA, gamma, AXIS);
    }

    private Turned turned(double gamma) {
        SplittableRandom random = new SplittableRandom(seed);
        Vector3d side = new Vector3d(AXIS).cross(0, 1, 0).normalize();
        Vector3d up = new Vector3d(side).cross(AXIS);
        Vector3d[] directions = new Vector3d[DIRECTIONS];
        BigDecimal[][] exact = new BigDecimal[DIRECTIONS][];
        for (int i = 0; i < DIRECTIONS; i++) {
            // angles from the motion that end at all angles in the scene
            double angle = Math.PI * Math.pow(10 * gamma, -random.nextDouble());
            double turn = 2 * Math.PI * random.nextDouble();
            directions[i] = new Vector3d(AXIS)
                    .mul(Math.cos(angle))
                    .fma(Math.sin(angle) * Math.cos(turn), side)
                    .fma(Math.sin(angle) * Math.sin(turn), up)
                    .normalize();
            exact[i] = exact(velocity(gamma).proper(), directions[i]);
        }
        return new Turned(directions, exact);
    }

    private static double seconds(Runnable task) {
        Stopwatch.warmUp(task);
        return Stopwatch.seconds(task);
    }

    private static void turnAll(DirectionForm.Direction turning, Vector3d[] directions, Vector3d result) {
        for (int i = 0; i < TIMED; i++) {
            turning.turn(directions[i % DIRECTIONS], result);
        }
    }

    /** The unit direction in the scene frame, and the length that the transformation gives it. */
    private static BigDecimal[] exact(Vector3dc u, Vector3dc d) {
        BigDecimal[] velocity = {new BigDecimal(u.x()), new BigDecimal(u.y()), new BigDecimal(u.z())};
        BigDecimal[] direction = {new BigDecimal(d.x()), new BigDecimal(d.y()), new BigDecimal(d.z())};
        BigDecimal gamma = dot(velocity, velocity).add(BigDecimal.ONE).sqrt(DIGITS);
        BigDecimal length = dot(direction, direction).sqrt(DIGITS);
        BigDecimal factor = dot(velocity, direction)
                .divide(gamma.add(BigDecimal.ONE), DIGITS)
                .subtract(length);
        BigDecimal[] turned = new BigDecimal[4];
        for (int i = 0; i < 3; i++) {
            turned[i] = direction[i].add(velocity[i].multiply(factor));
        }
        turned[3] = dot(turned, turned).sqrt(DIGITS);
        for (int i = 0; i < 3; i++) {
            turned[i] = turned[i].divide(turned[3], DIGITS);
        }
        return turned;
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    private static double angle(BigDecimal[] exact, Vector3dc found) {
        double sum = 0;
        double[] components = {found.x(), found.y(), found.z()};
        for (int i = 0; i < 3; i++) {
            if (Double.isNaN(components[i])) {
                return Math.PI;
            }
            double difference = exact[i].subtract(new BigDecimal(components[i])).doubleValue();
            sum += difference * difference;
        }
        return 2 * Math.asin(Math.min(1, Math.sqrt(sum) / 2));
    }

    @Override
    public List<Chart> charts() {
        return List.of(
                new Chart(
                                RADIANS,
                                "Direction in the scene",
                                Chart.setting("gamma"),
                                new Chart.Axis<>("largest error in radians", Measurement::error),
                                false)
                        .withOwn(DirectionForm.HALF_ANGLE.title()),
                new Chart(
                                PIXELS,
                                "Place in the picture",
                                Chart.setting("gamma"),
                                new Chart.Axis<>("largest error in pixels", Measurement::error),
                                false)
                        .withOwn(DirectionForm.HALF_ANGLE.title()));
    }

    @Override
    public String answer(List<Measurement> all) {
        Measurement single = Measurement.of(PIXELS, DirectionForm.SINGLE.title(), TIMED_AT, all);
        Measurement own = Measurement.of(PIXELS, DirectionForm.HALF_ANGLE.title(), TIMED_AT, all);
        double singleNanoseconds = 1e9 * single.medianSeconds() / TIMED;
        double ownNanoseconds = 1e9 * own.medianSeconds() / TIMED;
        return StudyText.of(
                "precision.answer",
                single.medianError(),
                singleNanoseconds < ownNanoseconds
                        ? Finding.text("%.1f ns", ownNanoseconds - singleNanoseconds)
                        : "nothing",
                singleNanoseconds,
                ownNanoseconds);
    }

    @Override
    public List<Finding> findings(List<Measurement> all) {
        List<Finding> findings = new ArrayList<>();
        findings.add(slope(RADIANS, DirectionForm.PROPER_VELOCITY, 2, all));
        findings.add(slope(RADIANS, DirectionForm.MATRIX, 2, all));
        findings.add(slope(RADIANS, DirectionForm.HALF_ANGLE, 1, all));
        findings.add(slope(PIXELS, DirectionForm.PROPER_VELOCITY, 1, all));
        findings.add(slope(PIXELS, DirectionForm.MATRIX, 1, all));
        findings.add(slope(PIXELS, DirectionForm.HALF_ANGLE, 1, all));
        double worst = Measurement.of(PIXELS, DirectionForm.HALF_ANGLE.title(), Velocity.GUARANTEED_GAMMA, all)
                .medianError();
        findings.add(Finding.of(
                worst < 0.01,
                Finding.text("The program's largest error at gamma %.0g, in pixels", Velocity.GUARANTEED_GAMMA),
                "below 0.01",
                "%.2g",
                worst));
        double law = 3 * FLOAT_ROUNDING * TIMED_AT / PIXEL;
        double single = Measurement.of(PIXELS, DirectionForm.SINGLE.title(), TIMED_AT, all)
                .medianError();
        findings.add(Finding.of(
                single >= law / 4 && single <= 4 * law,
                "Single precision at gamma 1e4, in pixels",
                Finding.text("%.2g to %.2g (4 times the law 3 u gamma/pixel angle, or a quarter)", law / 4, 4 * law),
                "%.2g",
                single));
        return findings;
    }

    /** The power of gamma with which the error of a form grows. */
    static PowerLaw law(String problem, DirectionForm form, List<Measurement> all) {
        List<Measurement> points = Measurement.of(problem, form.title(), all).stream()
                .filter(point -> point.setting() >= 10 && point.medianError() < 0.1)
                .toList();
        return PowerLaw.ofError(points, Measurement::setting);
    }

    private static Finding slope(String problem, DirectionForm form, int expected, List<Measurement> all) {
        double slope = law(problem, form, all).slope();
        return Finding.of(
                Math.abs(slope - expected) <= 0.1,
                form.title() + ": power of gamma with which the error grows, in " + problem,
                Finding.text("%.1f to %.1f (theory: %d)", expected - 0.1, expected + 0.1, expected),
                "%.2f",
                slope);
    }
}
