package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Rotating;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

class MeasurementsTest {

    private static Quantity number(Measured measured, String key) {
        return measured.quantities()
                .filter(quantity -> quantity.key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    /** The centre of the circle through three points of a plane, by determinants. */
    private static Vector2d centre(List<Vector2dc> points) {
        Vector2d a = new Vector2d(points.get(1)).sub(points.get(0));
        Vector2d b = new Vector2d(points.get(2)).sub(points.get(0));
        double twice = 2 * (a.x * b.y - a.y * b.x);
        return new Vector2d(
                        b.y * a.lengthSquared() - a.y * b.lengthSquared(),
                        a.x * b.lengthSquared() - b.x * a.lengthSquared())
                .div(twice)
                .add(points.get(0));
    }

    /** The root of the sum of squares of what half a pixel in each point changes. */
    private static double effect(List<Vector2dc> points, ToDoubleFunction<List<Vector2dc>> number) {
        double squares = 0;
        for (int i = 0; i < points.size(); i++) {
            double most = 0;
            for (int side = 0; side < 4; side++) {
                List<Vector2dc> moved = new ArrayList<>(points);
                moved.set(
                        i,
                        new Vector2d(Math.cos(side * Math.PI / 2), Math.sin(side * Math.PI / 2))
                                .div(2)
                                .add(points.get(i)));
                most = Math.max(most, Math.abs(number.applyAsDouble(moved) - number.applyAsDouble(points)));
            }
            squares += most * most;
        }
        return Math.sqrt(squares);
    }

    /** The view of 0.64 degrees is so narrow that directions lie in a plane, in which each pixel is 0.001 degrees. */
    @Test
    void shortArcsTellCirclesBadly() {
        double pixel = 0.001;
        RenderPlan plan = RenderPlan.of(Studio.DEFAULT
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 640 * pixel))
                .withVelocity(Velocity.of(0, 0, 0.8)));
        List<Vector2dc> points = new ArrayList<>();
        for (int degrees = 75; degrees <= 105; degrees += 15) {
            double turn = Math.toRadians(degrees);
            points.add(new Vector2d(300 + 58 * Math.cos(turn), 200 + 58 * Math.sin(turn)));
        }

        Measured measured = Measurements.measure(plan, MeasureKind.CIRCLE, points, () -> true);

        double radius = effect(points, moved -> centre(moved).distance(moved.get(0)));
        // the middle point alone: (c^2 + s^2)/2s with half the chord c and the height s, half a pixel less
        double chord = 58 * Math.sin(Math.toRadians(15));
        double height = 58 * (1 - Math.cos(Math.toRadians(15))) - 0.5;
        assertThat(radius).isGreaterThan((chord * chord + height * height) / (2 * height) - 58);
        assertThat(number(measured, "halfAngle").value()).isCloseTo(58 * pixel, within(1e-5));
        assertThat(number(measured, "halfAngle").uncertainty()).isCloseTo(radius * pixel, withinPercentage(0.1));
        double toMotion = effect(points, moved -> centre(moved).distance(320, 240));
        assertThat(number(measured, "middleAngleToVelocity").uncertainty())
                .isCloseTo(toMotion * pixel, withinPercentage(0.1));
    }

    /**
     * Points 1 and 2 beside the axis of a disc in the distance 10, whose clocks go by sqrt(1 - 0.04), sqrt(1 - 0.16).
     */
    @Test
    void pointsOfWhatTurnsShareNoRestFrame() {
        Measured atRest = acrossDisc(0);
        Measured turning = acrossDisc(0.2);

        assertThat(number(atRest, "objectDistance").value()).isCloseTo(1, within(1e-12));
        double later = Math.sqrt(101) - Math.sqrt(104);
        assertThat(number(atRest, "objectTime").value()).isCloseTo(later, within(1e-12));
        assertThat(turning.quantities().map(Quantity::key))
                .contains("sceneDistance", "cameraTime")
                .doesNotContain("objectDistance", "objectTime");
        assertThat(number(turning, "sceneTime").value()).isCloseTo(later, within(1e-12));
        assertThat(number(turning, "sceneDistance").isUncertain()).isTrue();
    }

    /** From 1 to 2 beside the axis of a disc that turns. */
    private static Measured acrossDisc(double angularSpeed) {
        Vector3d centre = new Vector3d(0, 0, 10);
        Vector3d axis = new Vector3d(0, 0, 1);
        Disc disc = new Disc("disc", centre, axis, 3, LuminousSurface.DEFAULT);
        Studio studio = Studio.DEFAULT.withScene(
                List.of(new Rotating("turning", centre, axis, angularSpeed, 0, List.of(disc))));
        Projection projection = Projection.of(studio);
        List<Vector2dc> points = List.of(
                projection.position(new Vector3d(1, 0, 10).normalize()),
                projection.position(new Vector3d(2, 0, 10).normalize()));
        return Measurements.measure(RenderPlan.of(studio), MeasureKind.BETWEEN, points, () -> true);
    }

    /** Two points half a pixel apart may be one: nothing tells by how much their circle is uncertain. */
    @Test
    void pointsTooNearTellNoUncertainty() {
        List<Vector2dc> points = List.of(new Vector2d(100, 100), new Vector2d(100.5, 100), new Vector2d(120, 130));

        Measured measured = Measurements.measure(RenderPlan.of(Studio.DEFAULT), MeasureKind.CIRCLE, points, () -> true);

        assertThat(number(measured, "halfAngle").value()).isPositive();
        assertThat(number(measured, "halfAngle").isUncertain()).isFalse();
    }
}
