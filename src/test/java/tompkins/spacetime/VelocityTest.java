package tompkins.spacetime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;

class VelocityTest {

    private static final double SMALL = 1e-15;
    /** The same speed, 0.6, on every scale: gamma 1.25, rapidity ln 2. */
    @ParameterizedTest
    @CsvSource({"BETA, 0.6", "GAMMA, 1.25", "RAPIDITY, 0.6931471805599453", "ONE_MINUS_BETA, 0.4"})
    void allScalesMeanTheSameSpeed(SpeedScale scale, double value) {
        Velocity velocity = Velocity.of(scale, value, new Vector3d(0, 3, 4));
        assertThat(velocity.speed()).isCloseTo(0.6, within(SMALL));
        assertThat(velocity.gamma()).isCloseTo(1.25, within(SMALL));
        assertThat(velocity.gammaMinusOne()).isCloseTo(0.25, within(SMALL));
        assertThat(velocity.rapidity()).isCloseTo(Math.log(2), within(SMALL));
        assertThat(velocity.oneMinusSpeed()).isCloseTo(0.4, within(SMALL));
        assertThat(velocity.properSpeed()).isCloseTo(0.75, within(SMALL));
        assertThat(velocity.expMinusRapidity()).isCloseTo(0.5, within(SMALL));
        assertThat(velocity.components().distance(0, 0.36, 0.48)).isLessThan(SMALL);
        assertThat(velocity.proper().distance(0, 0.45, 0.6)).isLessThan(SMALL);
        assertThat(velocity.direction().distance(0, 0.6, 0.8)).isLessThan(SMALL);
        assertThat(velocity.isRest()).isFalse();
        assertThat(velocity.scale()).isEqualTo(scale);
        assertThat(velocity.value()).isEqualTo(value);
        assertThat(velocity.given()).isEqualTo(new Vector3d(0, 3, 4));
        assertThat(scale.valueOf(velocity)).isEqualTo(value);
        assertThat(velocity).hasToString(scale.key() + " " + NumberText.of(value) + " along [0, 3, 4]");
        for (SpeedScale other : SpeedScale.values()) {
            Velocity same = Velocity.of(other, other.valueOf(velocity), new Vector3d(0, 3, 4));
            assertThat(same.proper().distance(velocity.proper())).isLessThan(4 * SMALL);
        }
    }

    @Test
    void componentsAreKeptAsTheyWereGiven() {
        Velocity velocity = Velocity.of(0.2, -0.1, 0.97);
        assertThat(velocity.components()).isEqualTo(new Vector3d(0.2, -0.1, 0.97));
        assertThat(velocity.given()).isEqualTo(new Vector3d(0.2, -0.1, 0.97));
        assertThat(velocity.scale()).isNull();
        assertThat(velocity.value()).isZero();
        assertThat(velocity.speed()).isCloseTo(new Vector3d(0.2, -0.1, 0.97).length(), within(SMALL));
        assertThat(velocity.oneMinusSpeed()).isCloseTo(1 - new Vector3d(0.2, -0.1, 0.97).length(), within(SMALL));
        assertThat(velocity).hasToString("[0.2, -0.1, 0.97]");
    }

    @Test
    void theDirectionIsThatWhichWasGivenElseForwards() {
        Vector3d sideways = new Vector3d(-2, 0, 0);
        assertThat(Velocity.REST.isRest()).isTrue();
        assertThat(Velocity.REST.direction()).isEqualTo(new Vector3d(0, 0, 1));
        assertThat(Velocity.REST.gamma()).isEqualTo(1);
        assertThat(Velocity.REST.givenDirection()).isEqualTo(new Vector3d(0, 0, 1));
        assertThat(Velocity.of(SpeedScale.GAMMA, 1, sideways).proper()).isEqualTo(new Vector3d());
        assertThat(Velocity.of(SpeedScale.GAMMA, 1, sideways).givenDirection()).isEqualTo(sideways);
        assertThat(Velocity.of(SpeedScale.BETA, 0.5, sideways).givenDirection()).isEqualTo(sideways);
        assertThat(Velocity.of(0, 0.3, -0.4).givenDirection()).isEqualTo(new Vector3d(0, 0.3, -0.4));
        assertThat(Velocity.of(0, 1e-200, 0).givenDirection()).isEqualTo(new Vector3d(0, 1e-200, 0));
    }

    /** Digits beyond what the speed itself can hold. */
    @Test
    void speedsNextToLightKeepTheirOwnNumber() {
        Velocity velocity = Velocity.of(SpeedScale.ONE_MINUS_BETA, 1e-20, new Vector3d(1, 0, 0));
        assertThat(velocity.speed()).isEqualTo(1);
        assertThat(velocity.oneMinusSpeed()).isEqualTo(1e-20);
        assertThat(velocity.gamma()).isCloseTo(Math.sqrt(0.5) * 1e10, within(1e-5));
        Velocity fast = Velocity.of(SpeedScale.RAPIDITY, 20, new Vector3d(1, 0, 0));
        // 1 - tanh(20) = 2/(exp(40) + 1)
        assertThat(fast.oneMinusSpeed()).isEqualTo(2 / (Math.exp(40) + 1), within(1e-31));
        assertThat(fast.rapidity()).isEqualTo(20);
    }

    @Test
    void equalityIsThatOfTheWayItWasGiven() {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, 3, new Vector3d(0, 1, 0));
        assertThat(velocity)
                .isEqualTo(Velocity.of(SpeedScale.GAMMA, 3, new Vector3d(0, 1, 0)))
                .hasSameHashCodeAs(Velocity.of(SpeedScale.GAMMA, 3, new Vector3d(0, 1, 0)))
                .isNotEqualTo(Velocity.of(SpeedScale.RAPIDITY, 3, new Vector3d(0, 1, 0)))
                .isNotEqualTo(Velocity.of(SpeedScale.GAMMA, 4, new Vector3d(0, 1, 0)))
                .isNotEqualTo(Velocity.of(SpeedScale.GAMMA, 3, new Vector3d(0, 2, 0)))
                .isNotEqualTo(null)
                .isNotEqualTo("gamma 3");
        assertThat(Velocity.of(0, 0, 0.5).hashCode()).isNotEqualTo(velocity.hashCode());
        Velocity zero = Velocity.of(SpeedScale.BETA, 0.0, new Vector3d(0, 0, 1));
        assertThat(Velocity.of(SpeedScale.BETA, -0.0, new Vector3d(0, 0, 1)))
                .isEqualTo(zero)
                .hasSameHashCodeAs(zero);
    }

    @ParameterizedTest
    @CsvSource({
        "BETA, 1", "BETA, -0.1", "GAMMA, 0.99", "GAMMA, Infinity", "RAPIDITY, -1", "RAPIDITY, 1000",
        "ONE_MINUS_BETA, 0", "ONE_MINUS_BETA, 1.1", "BETA, NaN", "GAMMA, NaN", "RAPIDITY, NaN", "ONE_MINUS_BETA, NaN"
    })
    void numbersOffTheScaleAreRefused(SpeedScale scale, double value) {
        assertThatThrownBy(() -> Velocity.of(scale, value, new Vector3d(0, 0, 1)))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining(scale.key())
                .hasMessageContaining(scale.range())
                .hasMessageEndingWith(", was " + NumberText.of(value));
    }

    @ParameterizedTest
    @EnumSource
    void zeroVectorIsNoDirection(SpeedScale scale) {
        assertThatThrownBy(() -> Velocity.of(scale, 1, new Vector3d())).isInstanceOf(InvalidPropertyException.class);
    }
}
