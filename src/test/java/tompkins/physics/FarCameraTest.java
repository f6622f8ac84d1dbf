package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.Camera;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.PreciseEvent;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;

/** A camera that has been on its way for long, and an object beside it: where it is relative to the camera decides. */
class FarCameraTest {

    private static final MathContext DIGITS = new MathContext(80);
    private static final Vector3dc BETA = new Vector3d(0.2, -0.1, 0.97);

    /** The place of the lens in the scene at a time, with eighty digits: gamma beta t. */
    private static BigDecimal[] lensPlace(double time) {
        BigDecimal squared = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++) {
            squared = squared.add(new BigDecimal(BETA.get(axis)).pow(2));
        }
        BigDecimal gamma =
                BigDecimal.ONE.divide(BigDecimal.ONE.subtract(squared).sqrt(DIGITS), DIGITS);
        BigDecimal[] place = new BigDecimal[3];
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = gamma.multiply(new BigDecimal(BETA.get(axis))).multiply(new BigDecimal(time));
        }
        return place;
    }

    private static Photograph photograph(Vector3dc centre, double time) {
        SceneObject ball = new Sphere("ball", centre, 0.5, Photograph.WHITE);
        return Photograph.of(
                List.of(ball), Photograph.pinhole(new Vector3d(0, 0, 1), 1, time), Velocity.of(BETA), 10, 10);
    }

    /** The distance of the ball of radius 1/2, from the exact difference of two far places. */
    private static double expectedDistance(BigDecimal[] lens, Vector3dc centre, Vector3dc direction) {
        Vector3d toCentre = new Vector3d();
        for (int axis = 0; axis < 3; axis++) {
            toCentre.setComponent(
                    axis, new BigDecimal(centre.get(axis)).subtract(lens[axis]).doubleValue());
        }
        double along = toCentre.dot(direction);
        double offset = toCentre.sub(new Vector3d(direction).mul(along)).length();
        return along - Math.sqrt((0.5 - offset) * (0.5 + offset));
    }

    private static Vector3d ballCentre(BigDecimal[] lens, Vector3dc direction) {
        return new Vector3d(lens[0].doubleValue(), lens[1].doubleValue(), lens[2].doubleValue())
                .add(new Vector3d(direction).mul(8));
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 1e3, 1e6, -1e6, 1e9, 1e12, 1.234567e14})
    void hitsKeepTheirDigits(double time) {
        BigDecimal[] lens = lensPlace(time);
        Vector3dc direction = photograph(new Vector3d(), time).trace(5, 5).sceneDirection();
        Vector3d centre = ballCentre(lens, direction);
        SampleHistory ray = photograph(centre, time).trace(5, 5);
        assertThat(ray.hits()).hasSize(1);
        double error = Math.abs(ray.hits().get(0).distance() - expectedDistance(lens, centre, direction));
        // in coordinates of order 1000 gamma the scene keeps its own origin: 1e4 u
        assertThat(error).isLessThan(Math.abs(time) < 1e4 ? 2e-11 : 2e-13);
    }

    /** The rest between the lens and the scene's own origin, for every way to give a velocity. */
    @ParameterizedTest
    @CsvSource({"BETA, 0.9", "GAMMA, 10.5", "RAPIDITY, 3", "ONE_MINUS_BETA, 1e-6"})
    void allScalesKeepTheirDigits(SpeedScale scale, double value) {
        Velocity velocity = Velocity.of(scale, value, new Vector3d(0, 0, 2));
        LorentzTransformation sceneFromCamera = new LorentzTransformation(velocity);
        Event event = new Event(1, 2, 3, 1e12);
        Vector3d near = sceneFromCamera.transform(event).position();
        Vector3d rest = sceneFromCamera
                .transform(PreciseEvent.of(event))
                .minus(new Event(near.x, near.y, near.z, 0))
                .rounded()
                .position();
        // along z: z' = gamma z + gamma beta t
        BigDecimal one = BigDecimal.ONE;
        BigDecimal exactValue = new BigDecimal(value);
        BigDecimal gamma = switch (scale) {
            case BETA -> one.divide(one.subtract(exactValue.pow(2)).sqrt(DIGITS), DIGITS);
            case GAMMA -> exactValue;
            case ONE_MINUS_BETA ->
                one.divide(
                        exactValue
                                .multiply(new BigDecimal(2).subtract(exactValue))
                                .sqrt(DIGITS),
                        DIGITS);
            case RAPIDITY -> exponential(3).add(exponential(-3)).divide(new BigDecimal(2), DIGITS);
        };
        BigDecimal proper = gamma.pow(2).subtract(one).sqrt(DIGITS);
        BigDecimal expected = gamma.multiply(new BigDecimal(3))
                .add(proper.multiply(new BigDecimal(1e12)))
                .subtract(new BigDecimal(near.z));
        assertThat(Math.abs(rest.z - expected.doubleValue())).isLessThan(1e-15 + 1e-15 * Math.abs(rest.z));
        assertThat(rest.x).isZero();
    }

    private static BigDecimal exponential(int power) {
        BigDecimal sum = BigDecimal.ONE;
        BigDecimal term = BigDecimal.ONE;
        for (int n = 1; n < 120; n++) {
            term = term.multiply(new BigDecimal(power)).divide(new BigDecimal(n), DIGITS);
            sum = sum.add(term);
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1e12})
    void galileanCamerasKeepTheirDigitsToo(double time) {
        Vector3d centre = new Vector3d();
        for (int axis = 0; axis < 3; axis++) {
            centre.setComponent(axis, BETA.get(axis) * time);
        }
        centre.z += 8;
        Studio far = photograph(centre, time).studio().withTransformation(TransformationLaw.GALILEAN);
        // a unit vector d with d - beta along z
        double ahead = Math.sqrt(BETA.z() * BETA.z() + 1 - BETA.lengthSquared()) - BETA.z();
        Studio looking = far.withCamera(Photograph.pinhole(new Vector3d(BETA).add(0, 0, ahead), 1, time));
        SampleHistory ray = new Photograph(looking).trace(5, 5);
        BigDecimal[] lens = new BigDecimal[3];
        for (int axis = 0; axis < 3; axis++) {
            lens[axis] = new BigDecimal(BETA.get(axis)).multiply(new BigDecimal(time));
        }
        assertThat(ray.hits()).hasSize(1);
        assertThat(Math.abs(ray.hits().get(0).distance() - expectedDistance(lens, centre, ray.sceneDirection())))
                .isLessThan(1e-12);
    }

    /** A ball in a train of which another part passed the camera long ago, or will. */
    @ParameterizedTest
    @ValueSource(doubles = {1e6 / 7, -1e9 / 7, 1e12 / 7})
    void partsOfALongTrainKeepTheirDigits(double time) {
        double place = -0.75 * time - 4;
        BigDecimal passing = new BigDecimal(-0.75).multiply(new BigDecimal(time));
        double fromThere = new BigDecimal(place).subtract(passing).doubleValue();

        assertThat(distanceInTrain(place, time)).isCloseTo(distanceInTrain(fromThere, 0), within(1e-12));
    }

    private static double distanceInTrain(double place, double time) {
        // gamma beta = 0.75 is a double
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, 1.25, new Vector3d(1, 0, 0));
        SceneObject ball = new Sphere("ball", new Vector3d(place, 1, 8), 3, Photograph.WHITE);
        SceneObject train = new Moving("train", velocity, new Vector3d(), 0, List.of(ball));
        Camera camera = Photograph.pinhole(new Vector3d(-0.8, 0.1, 0.8), 1, time);
        Photograph photograph = Photograph.of(List.of(train), camera, Velocity.REST, 10, 10);
        return photograph.trace(5, 5).hits().get(0).distance();
    }
}
