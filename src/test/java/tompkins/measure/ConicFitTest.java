package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Moving;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

class ConicFitTest {

    private static final double TURN = 0.4;
    private static final Vector2d MIDDLE = new Vector2d(30, -7);

    /** A point of the plane, given along the axes of a curve that is turned and shifted. */
    private static Vector2d turned(double along, double across) {
        return new Vector2d(
                        along * Math.cos(TURN) - across * Math.sin(TURN),
                        along * Math.sin(TURN) + across * Math.cos(TURN))
                .add(MIDDLE);
    }

    private static List<Vector2d> ellipse(int count, double a, double b) {
        List<Vector2d> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double angle = 0.3 + 2 * Math.PI * i / count;
            points.add(turned(a * Math.cos(angle), b * Math.sin(angle)));
        }
        return points;
    }

    /** Points of one branch, x = side a cosh s, y = b sinh s. */
    private static List<Vector2d> branch(int count, double a, double b, int side) {
        List<Vector2d> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double s = -1.1 + 2.4 * i / (count - 1);
            points.add(turned(side * a * Math.cosh(s), b * Math.sinh(s)));
        }
        return points;
    }

    @ParameterizedTest
    @ValueSource(ints = {5, 6, 20})
    void ellipsesKeepTheirNumbers(int count) {
        ConicFit fit = ConicFit.of(ellipse(count, 5, 3), 1e-3);

        assertThat(fit.kind()).isEqualTo(ConicFit.Kind.ELLIPSE);
        assertThat(fit.conic().semiMajorAxis()).isCloseTo(5, within(1e-10));
        assertThat(fit.conic().semiMinorAxis()).isCloseTo(3, within(1e-10));
        assertThat(fit.conic().eccentricity()).isCloseTo(0.8, within(1e-11));
        assertThat(fit.conic().semiLatusRectum()).isCloseTo(1.8, within(1e-10));
        assertThat(fit.conic().centre().distance(MIDDLE)).isLessThan(1e-9);
        assertThat(Math.abs(fit.conic().towardsVertex().dot(new Vector2d(Math.cos(TURN), Math.sin(TURN)))))
                .isCloseTo(1, within(1e-12));
        assertThat(fit.residual()).isLessThan(1e-10);
    }

    @ParameterizedTest
    @CsvSource({"5, 2, 3, 1", "12, 2, 3, 1", "12, 2, 3, -1", "12, 3, 0.5, 1"})
    void hyperbolasKeepTheirNumbers(int count, double a, double b, int side) {
        ConicFit fit = ConicFit.of(branch(count, a, b, side), 1e-4);

        assertThat(fit.kind()).isEqualTo(ConicFit.Kind.HYPERBOLA);
        assertThat(fit.conic().semiMajorAxis()).isCloseTo(a, within(1e-8));
        assertThat(fit.conic().semiMinorAxis()).isCloseTo(b, within(1e-8));
        assertThat(fit.conic().asymptoteSlope()).isCloseTo(b / a, within(1e-8));
        assertThat(fit.conic().centre().distance(MIDDLE)).isLessThan(1e-7);
    }

    @Test
    void bothBranchesAreOneHyperbola() {
        List<Vector2d> points = branch(6, 2, 3, 1);
        points.addAll(branch(6, 2, 3, -1));

        ConicFit fit = ConicFit.of(points, 1e-4);

        assertThat(fit.conic().semiMajorAxis()).isCloseTo(2, within(1e-10));
        assertThat(points.stream().filter(fit.conic()::isOnThisSide)).hasSize(6);
    }

    /** y² = 4 f x has the distance 2 f from its focus, across the axis. */
    @Test
    void parabolasKeepTheirNumbers() {
        List<Vector2d> points = new ArrayList<>();
        for (int i = -4; i <= 5; i++) {
            points.add(turned(i * i / 8.0, i));
        }

        ConicFit fit = ConicFit.of(points, 1e-3);

        assertThat(fit.kind()).isEqualTo(ConicFit.Kind.PARABOLA);
        assertThat(fit.conic().eccentricity()).isCloseTo(1, within(1e-7));
        assertThat(fit.conic().semiLatusRectum()).isCloseTo(4, within(1e-7));
        assertThat(new Vector2d(fit.conic().focus()).distance(turned(2, 0))).isLessThan(1e-7);
    }

    @Test
    void circlesAreEllipsesWithoutEccentricity() {
        ConicFit fit = ConicFit.of(ellipse(9, 4, 4), 1e-2);

        assertThat(fit.kind()).isEqualTo(ConicFit.Kind.ELLIPSE);
        assertThat(fit.conic().eccentricity()).isLessThan(1e-6);
        assertThat(fit.conic().semiMajorAxis()).isCloseTo(4, within(1e-9));
        // sqrt(1 - b²/a²) of two half axes that are known to 0.01 sqrt(2/9) sqrt(2) or so
        assertThat(fit.uncertainty(Conic::eccentricity)).isBetween(0.03, 0.15);
        // its axis is any diameter
        assertThat(fit.axisUncertainty()).isCloseTo(Math.PI / 2, within(1e-15));
    }

    /** All places of the equation seen from the focus are places of the curve. */
    @Test
    void placesLieOnTheCurve() {
        Conic ellipse = ConicFit.of(ellipse(8, 5, 3), 1e-3).conic();
        Conic hyperbola = ConicFit.of(branch(8, 2, 3, 1), 1e-3).conic();
        for (double azimuth = 0.1; azimuth < 6; azimuth += 0.5) {
            assertThat(equation(ellipse.point(azimuth), 5, 3, 1)).isCloseTo(1, within(1e-9));
            assertThat(equation(hyperbola.point(azimuth), 2, 3, -1)).isCloseTo(1, within(1e-7));
        }
    }

    private static double equation(Vector2d place, double a, double b, int sign) {
        Vector2d from = place.sub(MIDDLE, new Vector2d());
        double along = (from.x * Math.cos(TURN) + from.y * Math.sin(TURN)) / a;
        double across = (from.y * Math.cos(TURN) - from.x * Math.sin(TURN)) / b;
        return along * along + sign * across * across;
    }

    /** Of numbers with noise, two thirds lie within the uncertainty, and their mean is not off. */
    @Test
    void uncertaintiesAreThoseOfNoise() {
        assertNoise(ellipse(16, 5, 3), Conic::eccentricity, 0.8);
        assertNoise(ellipse(16, 5, 3), Conic::semiMajorAxis, 5);
        assertNoise(branch(16, 2, 3, 1), Conic::semiLatusRectum, 4.5);
        assertNoise(branch(16, 2, 3, 1), Conic::asymptoteSlope, 1.5);
    }

    /** Points that are farther off than they should be make the numbers as uncertain as that. */
    @Test
    void scatterCountsWherePointsAreOff() {
        List<Vector2d> points = ellipse(16, 5, 3);
        for (int i = 0; i < points.size(); i++) {
            points.get(i).add(0, i % 2 == 0 ? 0.1 : -0.1);
        }

        double exact = ConicFit.of(points, 1e-6).uncertainty(Conic::semiMajorAxis);
        assertThat(exact).isBetween(0.02, 0.1);
        assertThat(ConicFit.of(points, 1).uncertainty(Conic::semiMajorAxis)).isGreaterThan(5 * exact);
    }

    /** Of points that are far off, no ellipse beside the fit has a smaller sum of squared distances, to first order. */
    @Test
    void noConicBesideItIsBetter() {
        Random random = new Random(11);
        List<Vector2d> points = ellipse(14, 5, 3);
        points.forEach(point -> point.add(0.6 * random.nextGaussian(), 0.6 * random.nextGaussian()));
        ConicFit fit = ConicFit.of(points, 0.6);
        Conic conic = fit.conic();
        Vector2d centre = conic.centre();
        double[] best = {
            conic.semiMajorAxis(),
            conic.semiMinorAxis(),
            centre.x,
            centre.y,
            Math.atan2(conic.towardsVertex().y(), conic.towardsVertex().x())
        };

        assertThat(fit.kind()).isEqualTo(ConicFit.Kind.ELLIPSE);
        assertThat(fit.residual()).isCloseTo(Math.sqrt(squares(points, best) / points.size()), within(1e-9));
        for (int i = 0; i < best.length; i++) {
            for (double step : new double[] {-1e-4, 1e-4}) {
                double[] beside = best.clone();
                beside[i] += step;
                assertThat(squares(points, beside)).isGreaterThan(squares(points, best));
            }
        }
    }

    /** Sum of squares of x²/a² + y²/b² - 1, each divided by its gradient, for half axes, centre and turn. */
    private static double squares(List<Vector2d> points, double... ellipse) {
        double sum = 0;
        for (Vector2d point : points) {
            double toX = point.x - ellipse[2];
            double toY = point.y - ellipse[3];
            double x = (toX * Math.cos(ellipse[4]) + toY * Math.sin(ellipse[4])) / ellipse[0];
            double y = (toY * Math.cos(ellipse[4]) - toX * Math.sin(ellipse[4])) / ellipse[1];
            double distance = (x * x + y * y - 1) / (2 * Math.hypot(x / ellipse[0], y / ellipse[1]));
            sum += distance * distance;
        }
        return sum;
    }

    private static void assertNoise(List<Vector2d> exact, ToDoubleFunction<Conic> number, double truth) {
        double noise = 0.02;
        Random random = new Random(7);
        int trials = 400;
        int inside = 0;
        double sum = 0;
        double uncertainty = 0;
        for (int trial = 0; trial < trials; trial++) {
            List<Vector2d> noisy = exact.stream()
                    .map(point -> new Vector2d(point).add(noise * random.nextGaussian(), noise * random.nextGaussian()))
                    .toList();
            ConicFit fit = ConicFit.of(noisy, noise);
            double miss = number.applyAsDouble(fit.conic()) - truth;
            uncertainty = fit.uncertainty(number);
            inside += Math.abs(miss) < uncertainty ? 1 : 0;
            sum += miss;
        }
        assertThat(inside / (double) trials).isBetween(0.62, 0.76);
        assertThat(Math.abs(sum / trials)).isLessThan(uncertainty / 4);
    }

    /**
     * An upright rod that flies through the plane z = d is seen on x = -v gamma sqrt(d² + y²) (Boas 1961): a hyperbola
     * with the eccentricity 1/v, whose half axes are v gamma and 1 on the plane at distance 1. The points are the
     * middles of the rod in traced rows.
     */
    @Test
    void tracedRodsAreHyperbolasOfTheirSpeed() {
        double v = 0.9;
        Studio studio = Studio.DEFAULT
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 150.0)
                        .withShutter(new AperturePlaneShutter(0)))
                .withScene(List.of(new Moving(
                        "",
                        Velocity.of(v, 0, 0),
                        new Vector3d(),
                        0,
                        List.of(new Cylinder(
                                "",
                                new Vector3d(0, -9, 2),
                                new Vector3d(0, 9, 2),
                                0.01,
                                false,
                                LuminousSurface.DEFAULT)))));
        RenderPlan plan = RenderPlan.of(studio);
        List<Vector2dc> places = new ArrayList<>();
        for (int row = 120; row < 370; row += 30) {
            places.add(new Vector2d(middle(plan, row), row));
        }

        Measured measured = Measurements.measure(plan, MeasureKind.CONIC, places, 2, () -> true);

        double gamma = 1 / Math.sqrt(1 - v * v);
        assertThat(measured.facts()).contains(new Fact.Word("shape", "shape", "hyperbola"));
        assertThat(value(measured, "eccentricity")).isCloseTo(1 / v, within(1e-3));
        assertThat(value(measured, "semiMajorAxis")).isCloseTo(v * gamma, within(3e-3));
        assertThat(value(measured, "semiMinorAxis")).isCloseTo(1, within(3e-3));
        assertThat(value(measured, "asymptoteSlope")).isCloseTo(1 / (v * gamma), within(3e-3));
        assertThat(value(measured, "axisAngle")).isCloseTo(0, within(0.05));
        assertThat(value(measured, "centrePixelX")).isCloseTo(319.5, within(0.5));
        assertThat(value(measured, "residualInPixels")).isLessThan(0.05);
        // what is drawn passes through the places, on this branch alone
        assertThat(measured.lines()).isNotEmpty();
        assertThat(measured.lines().stream().flatMap(List::stream)).allMatch(place -> place.x() < 320);
        for (Vector2dc place : places) {
            assertThat(distance(measured.lines(), place)).isLessThan(0.3);
        }
    }

    /** The distance of a place from lines. */
    private static double distance(List<List<Vector2dc>> lines, Vector2dc place) {
        double least = Double.POSITIVE_INFINITY;
        for (List<Vector2dc> line : lines) {
            for (int i = 1; i < line.size(); i++) {
                Vector2dc from = line.get(i - 1);
                Vector2dc to = line.get(i);
                least = Math.min(least, Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), place.x(), place.y()));
            }
        }
        return least;
    }

    private static double value(Measured measured, String key) {
        return measured.quantities()
                .filter(quantity -> quantity.key().equals(key))
                .findFirst()
                .orElseThrow()
                .value();
    }

    /** The middle of the columns at which the rays of a row hit the rod, 4 pixels around where it should be at most. */
    private static double middle(RenderPlan plan, int row) {
        double first = Double.NaN;
        double last = Double.NaN;
        double height = (row - 240) * Math.tan(Math.toRadians(75)) / 320;
        double expected = 320 - 320 / Math.tan(Math.toRadians(75)) * 0.9 / Math.sqrt(0.19) * Math.hypot(1, height);
        for (double x = expected - 4; x < expected + 4; x += 1 / 32.0) {
            if (Sighting.of(plan, x, row).hit() != null) {
                first = Double.isNaN(first) ? x : first;
                last = x;
            }
        }
        return (first + last) / 2;
    }

    @Test
    void pointsThatTellNoConicAreRefused() {
        List<Vector2d> line = new ArrayList<>();
        for (int i = 0; i < 7; i++) {
            line.add(new Vector2d(i, 3 * i + 1));
        }
        Vector2d one = new Vector2d(1, 2);
        assertThatThrownBy(() -> ConicFit.of(line, 0.5)).hasMessageContaining("must not lie on straight lines");
        assertThatThrownBy(() -> ConicFit.of(line.subList(0, 4), 0.5))
                .isInstanceOf(ArithmeticException.class)
                .hasMessage("a conic needs 5 points or more, not 4");
        assertThatThrownBy(() -> ConicFit.of(List.of(one, one, one, one, one), 0.5))
                .hasMessageContaining("must not coincide");
    }
}
