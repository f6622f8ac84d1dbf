package tompkins.study;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/**
 * How exact the forms of the transformation are, up to the highest speeds.
 *
 * @param seed of the directions
 */
record PrecisionStudy(long seed) implements Study {

    static final String RADIANS = "radians";
    static final String PIXELS = "pixels";

    private static final MathContext DIGITS = new MathContext(50);
    private static final int DIRECTIONS = 400;
    private static final double FLOAT_ROUNDING = 0x1p-24;
    private static final double PIXEL = Math.toRadians(20) / 640;

    /** The gamma at which single precision is compared with the program. */
    private static final double SINGLE_AT = 1e4;

    private static final double[] GAMMAS = {1.01, 3, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

    private static final List<DirectionForm> EXPECTED =
            List.of(DirectionForm.PROPER_VELOCITY, DirectionForm.HALF_ANGLE);

    private static final Vector3dc AXIS = new Vector3d(0.2, -0.1, 0.97).normalize();

    @Override
    public String settings() {
        return StudyText.of("precision.settings", seed, DIRECTIONS);
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
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, AXIS);
        DirectionForm.Direction turning = form.of(velocity);
        SplittableRandom random = new SplittableRandom(seed);
        Vector3d side = new Vector3d(AXIS).cross(0, 1, 0).normalize();
        Vector3d up = new Vector3d(side).cross(AXIS);
        Vector3d found = new Vector3d();
        double largest = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            // angles from the motion that end at all angles in the scene
            double angle = Math.PI * Math.pow(10 * gamma, -random.nextDouble());
            double turn = 2 * Math.PI * random.nextDouble();
            Vector3d direction = new Vector3d(AXIS)
                    .mul(Math.cos(angle))
                    .fma(Math.sin(angle) * Math.cos(turn), side)
                    .fma(Math.sin(angle) * Math.sin(turn), up)
                    .normalize();
            BigDecimal[] exact = exact(velocity.proper(), direction);
            turning.turn(direction, found);
            double error = angle(exact, found);
            // a picture shows the error where the Doppler factor shrinks or stretches it
            largest = Math.max(largest, problem.equals(RADIANS) ? error : error * exact[3].doubleValue() / PIXEL);
        }
        return Figures.of(DIRECTIONS, 0, largest);
    }

    /** The unit direction in the scene frame, and the length that the transformation gives it. */
    private static BigDecimal[] exact(Vector3dc u, Vector3dc d) {
        BigDecimal[] velocity = decimals(u);
        BigDecimal[] direction = decimals(d);
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

    static BigDecimal[] decimals(Vector3dc vector) {
        return new BigDecimal[] {new BigDecimal(vector.x()), new BigDecimal(vector.y()), new BigDecimal(vector.z())};
    }

    static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    private static double angle(BigDecimal[] exact, Vector3dc found) {
        if (!found.isFinite()) {
            return Math.PI;
        }
        double chord = new Vector3d(
                        difference(exact[0], found.x()),
                        difference(exact[1], found.y()),
                        difference(exact[2], found.z()))
                .length();
        return 2 * Math.asin(Math.min(1, chord / 2));
    }

    private static double difference(BigDecimal exact, double found) {
        return exact.subtract(new BigDecimal(found)).doubleValue();
    }

    @Override
    public List<Chart> charts() {
        return List.of(chart(RADIANS, "Direction in the scene"), chart(PIXELS, "Place in the picture"));
    }

    private static Chart chart(String problem, String title) {
        Chart.Axis error = new Chart.Axis("largest error in " + problem, StudyPoint::error);
        return new Chart(problem, title, Chart.setting("gamma"), error, false, DirectionForm.HALF_ANGLE.title());
    }

    @Override
    public void conclude(List<StudyPoint> all, Conclusion conclusion) {
        StudyPoint single = StudyPoint.of(PIXELS, DirectionForm.SINGLE.title(), SINGLE_AT, all);
        conclusion.say("precision.answer", single.medianError());
        for (String problem : List.of(RADIANS, PIXELS)) {
            for (DirectionForm form : EXPECTED) {
                // rounding of nearly equal numbers costs gamma twice, half angles once; the picture shrinks it by gamma
                int expected = problem.equals(RADIANS) && form != DirectionForm.HALF_ANGLE ? 2 : 1;
                double slope = law(problem, form, all).slope();
                conclusion.demand(
                        Math.abs(slope - expected) <= 0.1,
                        "precision.slope",
                        form.title(),
                        problem,
                        expected - 0.1,
                        expected + 0.1,
                        expected,
                        slope);
            }
        }
        double worst = StudyPoint.of(PIXELS, DirectionForm.HALF_ANGLE.title(), Velocity.GUARANTEED_GAMMA, all)
                .medianError();
        conclusion.demand(worst < 0.01, "precision.worst", Velocity.GUARANTEED_GAMMA, worst);
        double law = 3 * FLOAT_ROUNDING * SINGLE_AT / PIXEL;
        double error = single.medianError();
        conclusion.demand(error >= law / 4 && error <= 4 * law, "precision.single", law / 4, 4 * law, error);
    }

    /** The power of gamma with which the error of a form grows. */
    static PowerLaw law(String problem, DirectionForm form, List<StudyPoint> all) {
        List<StudyPoint> points = StudyPoint.of(problem, form.title(), all).stream()
                .filter(point -> point.setting() >= 10 && point.medianError() < 0.1)
                .toList();
        return PowerLaw.ofError(points, StudyPoint::setting);
    }
}
