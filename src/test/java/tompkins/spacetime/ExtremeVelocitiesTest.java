package tompkins.spacetime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.explain.Explanation;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Ray;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Cameras at rest, hardly moving, and next to the speed of light. */
class ExtremeVelocitiesTest {

    private static final double U = 0x1p-53;

    @ParameterizedTest
    @ValueSource(doubles = {1e-320, 1e-200, 1e-160, 1e-30, 1e-9, 1e-8, 1e-5})
    void tinySpeedsKeepTheirDigits(double speed) {
        Vector3d beta = new Vector3d(speed, 0, 0);
        Velocity velocity = Velocity.of(beta);
        assertThat(velocity.properSpeed()).isEqualTo(speed, within(speed * 1e-10));
        // t = -(gamma/(gamma + 1)) beta.x = -beta.x/2 (1 + beta^2/4 + ...)
        double expected = -speed * 3 / 2 * (1 + speed * speed / 4);
        double time = new LorentzTransformation(velocity).fixedPointTime(new Vector3d(3, 1, 1));
        assertThat(time).isEqualTo(expected, within(Math.abs(expected) * 4 * U + Double.MIN_VALUE));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1e8, 1e12, 1e100, 1e300})
    void anyGammaIsFinite(double gamma) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(1, 2, 3));
        Ray ray = new LorentzTransformation(velocity).transform(Ray.from(1, 2, 3, 0.6, 0, 0.8, 0));
        assertThat(Double.isFinite(ray.dx + ray.dy + ray.dz + ray.x + ray.time + ray.frequency))
                .isTrue();
        assertThat(velocity.gammaMinusOne()).isEqualTo(gamma - 1, within(gamma * 4 * U));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e6, 1.1e6, 1e8})
    void picturesBeyondTheGuaranteedGammaSaySo(double gamma) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(1, 2, 3));
        boolean warned = new Explanation(RenderPlan.of(Studio.DEFAULT.withVelocity(velocity)))
                .sentences().stream().anyMatch(sentence -> sentence.startsWith("Warning"));
        assertThat(warned).isEqualTo(gamma > 1e6);
    }

    @Test
    void lightAndFasterIsRefused() {
        for (Vector3d beta : new Vector3d[] {
            new Vector3d(1, 0, 0),
            new Vector3d(0.6, 0.8, 0),
            new Vector3d(0.8, 0.8, 0),
            new Vector3d(Double.NaN, 0, 0),
            new Vector3d(0, Double.POSITIVE_INFINITY, 0),
            new Vector3d(1e200, 0, 0)
        }) {
            assertThatThrownBy(() -> Velocity.of(beta)).isInstanceOf(InvalidPropertyException.class);
        }
    }
}
