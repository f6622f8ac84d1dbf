package tompkins.spacetime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** Rays that cross near the origin and far from it, with gamma 5/4 along z, where the change of frame is exact. */
class FrameTreeTest {

    private static final Velocity MOVING = Velocity.of(SpeedScale.GAMMA, 1.25, new Vector3d(0, 0, 1));

    /** The lens is at (1, 2, 5/4 z + 3/4 t) then. */
    private static Event lens(double time) {
        return new Event(1, 2, 3, time);
    }

    private static FrameTree frames(double time) {
        return FrameTree.near(lens(time), TransformationLaw.LORENTZ, MOVING);
    }

    private static FrameRoute crossing(double time) {
        FrameTree frames = frames(time);
        return frames.route(frames.camera(), null);
    }

    private static Ray ray(Event lens) {
        return Ray.from(lens.x() + 0.25, lens.y() - 0.5, lens.z() + 0.125, 0.6, 0, 0.8, lens.time() - 0.75);
    }

    /** z' = 5/4 z + 3/4 t, t' = 5/4 t + 3/4 z, in exact arithmetic. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1000, 1e5, 1e9, 1e13 + 1.0 / 512})
    void rayStartsWhereItStarts(double time) {
        Ray start = ray(lens(time));
        Event origin = frames(time).origin(null);
        Ray crossed = crossing(time).transform(start, Ray.blank());
        BigDecimal z = share(1.25, start.z).add(share(0.75, start.time));
        BigDecimal t = share(1.25, start.time).add(share(0.75, start.z));

        assertThat(crossed.x + origin.x()).isEqualTo(1.25);
        assertThat(crossed.y + origin.y()).isEqualTo(1.5);
        assertThat(z.subtract(new BigDecimal(origin.z()))
                        .subtract(new BigDecimal(crossed.z))
                        .doubleValue())
                .isCloseTo(0, within(1e-12));
        assertThat(crossed.time + origin.time()).isCloseTo(t.doubleValue(), within(1e-12 + 4e-16 * time));
        // d' = d + u ((u.d)/(gamma + 1) - 1) with u.d = 0.6, of length gamma - u.d = 0.65
        assertThat(crossed.dx).isCloseTo(0.6 / 0.65, within(1e-15));
        assertThat(crossed.dy).isZero();
        assertThat(crossed.dz).isCloseTo(0.25 / 0.65, within(1e-15));
    }

    private static BigDecimal share(double factor, double value) {
        return new BigDecimal(factor).multiply(new BigDecimal(value));
    }

    @ParameterizedTest
    @ValueSource(doubles = {7, 1e5, 1e13})
    void blockCrossesAsItsRays(double time) {
        FrameRoute crossing = crossing(time);
        Ray start = ray(lens(time));
        RayPacket block = new RayPacket(2);
        block.begin(2);
        block.set(0, start);
        block.set(1, start.dimmed(1).move(0.1, 0.2, 0.3, 0.4));

        crossing.transform(block);

        assertThat(block.ray(0)).usingRecursiveComparison().isEqualTo(crossing.transform(start, Ray.blank()));
        assertThat(block.ray(1))
                .usingRecursiveComparison()
                .isEqualTo(crossing.transform(start.dimmed(1).move(0.1, 0.2, 0.3, 0.4), Ray.blank()));
    }

    /** The lens is 3/4 t + 15/4 and a little more from the origin: up to a thousand units the scene keeps its own. */
    @Test
    void sceneHasAnOriginOfItsOwnFromAThousandUnits() {
        assertThat(frames(1327).origin(null).position()).isEqualTo(new Vector3d());
        assertThat(frames(1329).origin(null).position()).isEqualTo(new Vector3d(1, 2, 1000.5));
    }

    @Test
    void cameraAtRestKeepsTheOriginOfTheScene() {
        FrameTree frames = FrameTree.near(new Event(1e6, 0, 0, 1e9), TransformationLaw.LORENTZ, Velocity.REST);

        assertThat(frames.origin(null).position()).isEqualTo(new Vector3d());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY})
    void lensThatNoLightPassesMovesNoOrigin(double time) {
        FrameTree frames = frames(time);
        FrameMotion motion = new FrameMotion(null, MOVING, Event.ORIGIN);

        assertThat(frames.origin(null)).isEqualTo(Event.ORIGIN);
        assertThat(frames.origin(motion)).isEqualTo(Event.ORIGIN);
    }
}
