package tompkins.spacetime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The world line of constant proper acceleration, against closed forms and against products of boost matrices. */
class RiderTest {

    private static final Event ORIGIN = new Event(0, 0, 0, 0);
    private static final Offset<Double> EXACT = within(1e-12);

    private static Rider atRest() {
        return new Rider(ORIGIN, Velocity.REST);
    }

    private static Rider many(Rider rider, Vector3dc acceleration, double time, int steps) {
        Rider moment = rider;
        for (int i = 0; i < steps; i++) {
            moment = moment.after(acceleration, time / steps).rider();
        }
        return moment;
    }

    @ParameterizedTest
    @CsvSource({"0.5, 2, 1", "0.5, 2, 300", "1, 3, 7", "2, 1.5, 97", "1e-7, 3, 50"})
    void followsTheHyperbola(double a, double time, int steps) {
        Rider end = many(atRest(), new Vector3d(a, 0, 0), time, steps);
        double x = (Math.cosh(a * time) - 1) / a;
        // the closed form itself loses digits at small accelerations
        double tolerance = Math.max(1e-12, 4e-16 / a);
        assertThat(end.event().x()).isCloseTo(x, within(tolerance));
        assertThat(end.event().time()).isCloseTo(Math.sinh(a * time) / a, within(tolerance));
        assertThat(end.proper().x()).isCloseTo(Math.sinh(a * time), EXACT);
        assertThat(end.rapidity()).isCloseTo(a * time, EXACT);
        assertThat(end.event().y()).isZero();
        assertThat(end.event().z()).isZero();
    }

    @Test
    void smallStepsAreParabolas() {
        Rider end = atRest().after(new Vector3d(0, 1e-9, 0), 1).rider();
        assertThat(end.event().y()).isCloseTo(0.5e-9, within(1e-24));
    }

    @Test
    void withoutThrustMovesEvenly() {
        Rider rider = new Rider(new Event(1, 2, 3, 4), Velocity.of(0, 0.6, 0));
        Event end = rider.after(new Vector3d(), 8).rider().event();
        assertThat(end.x()).isEqualTo(1);
        assertThat(end.y()).isCloseTo(2 + 6, EXACT);
        assertThat(end.z()).isEqualTo(3);
        assertThat(end.time()).isCloseTo(4 + 10, EXACT);
    }

    @Test
    void brakesToRestAndWaits() {
        Rider rider = new Rider(ORIGIN, Velocity.of(0.48, 0.36, 0));
        assertThat(rider.rapidity() / 2).isCloseTo(Math.log(2) / 2, EXACT);
        Rider.Step stopped = rider.after(rider.brake(2), Math.log(2) / 2);
        Rider.Step end = stopped.rider().after(stopped.rider().brake(2), 5 - Math.log(2) / 2);
        double braking = Math.log(2) / 2;
        double way = (1.25 - 1) / 2;
        assertThat(end.rider().proper()).isEqualTo(new Vector3d());
        assertThat(end.rider().event().x()).isCloseTo(0.8 * way, EXACT);
        assertThat(end.rider().event().y()).isCloseTo(0.6 * way, EXACT);
        assertThat(end.rider().event().time()).isCloseTo(0.75 / 2 + 5 - braking, EXACT);
    }

    /** Thrust for an instant: a boost. Known angles: cos a = (g1 + g2)/(1 + g1 g2) for boosts at right angles. */
    @ParameterizedTest
    @CsvSource({"0.6, 0.768375, 12.6804", "0.8, 0.932952, 28.0725", "0.99, 0.999802, 73.9408"})
    void turnsByTheAngleOfWigner(double beta, double speed, double degrees) {
        double rapidity = Math.log((1 + beta) / (1 - beta)) / 2;
        Rider first = atRest().after(new Vector3d(1e9 * rapidity, 0, 0), 1e-9).rider();
        Rider.Step second = first.after(new Vector3d(0, 1e9 * rapidity, 0), 1e-9);
        assertThat(second.rider().velocity().speed()).isCloseTo(speed, within(1e-6));
        Vector3d turned = second.turn().transform(new Vector3d(1, 0, 0));
        assertThat(Math.toDegrees(Math.acos(turned.x))).isCloseTo(degrees, within(1e-4));
        double gamma = first.gamma();
        assertThat(turned.x).isCloseTo(2 * gamma / (1 + gamma * gamma), EXACT);
        assertThat(turned.z).isZero();
    }

    /** As the product of the boosts, matrix by matrix, of a tetrad that is carried along. */
    @Test
    void carriesAxesAsProductsOfBoostsDo() {
        Matrix4d carried = new Matrix4d();
        Rider rider = atRest();
        Quaterniondc turned = new Quaterniond();
        Vector3d onBoard = onBoardOf(0);
        for (int i = 0; i < 60; i++) {
            Rider.Step step = rider.after(onBoard, 0.1);
            carried.mul(boost(new Vector3d(onBoardOf(i))
                    .normalize()
                    .mul(Math.sinh(onBoardOf(i).length() * 0.1))));
            rider = step.rider();
            // the next thrust points elsewhere on board; told in the axes of the camera frame
            turned = step.turn().mul(turned, new Quaterniond());
            onBoard = turned.transform(onBoardOf(i + 1));
        }
        Vector4d velocity = carried.transform(new Vector4d(0, 0, 0, 1));
        assertThat(rider.proper().distance(velocity.x, velocity.y, velocity.z)).isLessThan(1e-10);
        // an axis on board, in the scene: by the matrices, and by one boost after the turn
        Vector4d axis = carried.transform(new Vector4d(1, 0, 0, 0));
        Vector3d turnedAxis = turned.transform(new Vector3d(1, 0, 0));
        Vector4d boosted = boost(rider.proper()).transform(new Vector4d(turnedAxis, 0));
        assertThat(axis.distance(boosted)).isLessThan(1e-10);
    }

    private static Vector3d onBoardOf(int step) {
        return new Vector3d(Math.sin(step), Math.cos(2 * step), 0.5);
    }

    /** From the frame that moves with a proper velocity: columns are its axes and its time. */
    private static Matrix4d boost(Vector3dc u) {
        double gamma = Math.sqrt(1 + u.lengthSquared());
        double f = 1 / (gamma + 1);
        return new Matrix4d(
                1 + f * u.x() * u.x(),
                f * u.x() * u.y(),
                f * u.x() * u.z(),
                u.x(),
                f * u.x() * u.y(),
                1 + f * u.y() * u.y(),
                f * u.y() * u.z(),
                u.y(),
                f * u.x() * u.z(),
                f * u.y() * u.z(),
                1 + f * u.z() * u.z(),
                u.z(),
                u.x(),
                u.y(),
                u.z(),
                gamma);
    }
}
