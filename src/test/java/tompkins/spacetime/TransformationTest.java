package tompkins.spacetime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** What all changes of frame have in common, and what the simple ones are. */
class TransformationTest {

    private static final Vector3d BETA = new Vector3d(0.2, -0.1, 0.7);
    private static final Event EVENT = new Event(3, -2, 5, 7);

    private static Ray ray() {
        Ray ray = Ray.from(3, -2, 5, 0.48, 0.6, 0.64, 7);
        ray.spread = 1e-3;
        return ray;
    }

    private static Vector3d start(Ray ray) {
        return new Vector3d(ray.x, ray.y, ray.z);
    }

    private static Vector3d direction(Ray ray) {
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    private static SpaceTimeTransformation transformation(TransformationLaw law) {
        return law.sceneFromCamera(Velocity.of(BETA));
    }

    /**
     * Almost along the motion, near the speed of light: d - beta is (theta, 0, epsilon - theta^2/2), and the frequency
     * grows by epsilon + beta theta^2/2, with epsilon = 1 - beta = 1/(2 gamma^2).
     */
    @ParameterizedTest
    @CsvSource({"1e3, 0", "1e3, 1e-6", "1e3, 1e-4", "1e8, 0", "1e8, 1e-17", "1e8, 1e-9", "6.5e7, 0", "9.45e7, 1e-8"})
    void galileanLightKeepsItsDigitsStraightAhead(double gamma, double theta) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(0, 0, 1));
        Ray ray = Ray.from(0, 0, 0, Math.sin(theta), 0, Math.cos(theta), 0);

        Ray moved = TransformationLaw.GALILEAN.sceneFromCamera(velocity).transform(ray);

        // of 1 - beta = 1/(2 gamma^2) (1 + 1/(4 gamma^2) + ...) the second term matters at low gamma
        double epsilon = 1 / (2 * gamma * gamma) * (1 + 1 / (4 * gamma * gamma));
        // the direction of the ray itself is rounded
        double along = epsilon - (1 - Math.cos(theta));
        double halfSine = Math.sin(theta / 2);
        double length = Math.hypot(Math.sin(theta), along);
        assertThat(moved.frequency)
                .isCloseTo(epsilon + (1 - epsilon) * 2 * halfSine * halfSine, withinPercentage(1e-8));
        assertThat(moved.dz).isCloseTo(along / length, within(1e-12));
        assertThat(moved.dx).isCloseTo(Math.sin(theta) / length, within(1e-12));
        assertThat(moved.slowness).isCloseTo(1 / length, withinPercentage(1e-9));
    }

    /** A ray is two events: its start, and one on its way. */
    @ParameterizedTest
    @EnumSource
    void raysGoWhereTheirEventsGo(TransformationLaw law) {
        SpaceTimeTransformation transformation = transformation(law);
        Ray moved = transformation.transform(ray());
        Event first = transformation.transform(EVENT);
        double way = 2.5;
        Event second = transformation.transform(new Event(3 + way * 0.48, -2 + way * 0.6, 5 + way * 0.64, 7 - way));
        assertThat(start(moved).distance(first.position())).isLessThan(1e-14);
        assertThat(moved.time).isCloseTo(first.time(), within(1e-14));
        double length = second.position().distance(first.position());
        assertThat(start(moved).add(direction(moved).mul(length)).distance(second.position()))
                .isLessThan(1e-13);
        assertThat(moved.timeAt(length)).isCloseTo(second.time(), within(1e-13));
        assertThat(direction(moved).length()).isCloseTo(1, within(1e-15));
    }

    @ParameterizedTest
    @EnumSource
    void raysOfABlockGoWhereTheyGoAlone(TransformationLaw law) {
        SpaceTimeTransformation transformation = transformation(law);
        RayPacket block = new RayPacket(4);
        block.begin(4);
        Ray[] rays = new Ray[4];
        for (int i = 0; i < 4; i++) {
            // ahead and behind, slow and fast light, changed before
            rays[i] = Ray.blank()
                    .setInFrame(ray(), i, 2, -i, 0.48, i < 2 ? 0.6 : -0.6, i % 2 == 0 ? 0.64 : -0.64, 3, 1 + i, 0.5, 2);
            block.set(i, rays[i]);
        }

        transformation.transform(block);

        for (int i = 0; i < 4; i++) {
            assertThat(block.ray(i)).usingRecursiveComparison().isEqualTo(transformation.transform(rays[i]));
        }
    }

    /** Eq. 1 of the paper for a direction that is traced backwards. */
    @Test
    void directionsTurnByTheFormulaOfThePaper() {
        Velocity velocity = Velocity.of(BETA);
        Vector3d along = new Vector3d(2, -1, 2).div(3);
        Vector3d proper = new Vector3d(along).mul(velocity.properSpeed());
        for (int i = 0; i < 20; i++) {
            Vector3d direction = new Vector3d(Math.sin(i), Math.cos(2 * i), Math.sin(3 * i + 1)).normalize();
            Vector3d expected = new Vector3d(direction).fma(proper.dot(direction) / (velocity.gamma() + 1) - 1, proper);

            double growth = LorentzTransformation.turn(velocity, along, direction);

            assertThat(growth).isCloseTo(expected.length(), within(1e-14));
            assertThat(direction.distance(expected.div(growth))).isLessThan(1e-14);
        }
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "GALILEAN")
    void bundlesGrowAsFrequenciesFall(TransformationLaw law) {
        Ray moved = transformation(law).transform(ray());
        assertThat(moved.frequency * moved.spread).isCloseTo(1e-3, within(1e-17));
    }

    @ParameterizedTest
    @EnumSource
    void inverseGoesBack(TransformationLaw law) {
        SpaceTimeTransformation transformation = transformation(law);
        Event back = transformation.inverse().transform(transformation.transform(EVENT));
        assertThat(back.position().distance(EVENT.position())).isLessThan(1e-13);
        assertThat(back.time()).isCloseTo(7, within(1e-13));
        Ray rayBack = transformation.inverse().transform(transformation.transform(ray()));
        assertThat(direction(rayBack).distance(direction(ray()))).isLessThan(1e-14);
        assertThat(rayBack.slowness).isCloseTo(1, within(1e-14));
    }

    @ParameterizedTest
    @EnumSource
    void fixedPointsKeepTheirPlace(TransformationLaw law) {
        SpaceTimeTransformation transformation = transformation(law);
        double time = transformation.fixedPointTime(EVENT.position());
        Event moved = transformation.transform(new Event(3, -2, 5, time));
        assertThat(moved.position().distance(EVENT.position())).isLessThan(1e-14);
    }

    @Test
    void restIsNoChange() {
        LorentzTransformation rest = new LorentzTransformation(Velocity.REST);
        assertThat(rest.transform(PreciseEvent.of(EVENT)).rounded()).isEqualTo(EVENT);
        assertThat(rest.transform(EVENT)).isEqualTo(EVENT);
        assertThat(direction(rest.transform(ray())).distance(0.48, 0.6, 0.64)).isLessThan(0x1p-52);
        assertThat(rest.fixedPointTime(BETA)).isZero();
        for (TransformationLaw law : TransformationLaw.values()) {
            assertThat(law.sceneFromCamera(Velocity.REST)).isInstanceOf(IdentityTransformation.class);
        }
        IdentityTransformation identity = new IdentityTransformation();
        Ray ray = ray();
        assertThat(identity.transform(ray)).usingRecursiveComparison().isEqualTo(ray);
        assertThat(identity.transform(EVENT)).isSameAs(EVENT);
        assertThat(identity.inverse()).isEqualTo(identity);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-160, 100, 1e160, 1e300})
    void lengthOfTheDirectionDoesNotMatter(double length) {
        LorentzTransformation transformation = new LorentzTransformation(Velocity.of(BETA));
        Vector3d one = new Vector3d();
        Vector3d other = new Vector3d();
        double ratio = transformation.direction(new Vector3d(0.48, 0.6, 0.64), one);
        assertThat(transformation.direction(new Vector3d(0.48, 0.6, 0.64).mul(length), other))
                .isCloseTo(ratio, within(1e-15));
        assertThat(one.distance(other)).isLessThan(1e-15);
    }
}
