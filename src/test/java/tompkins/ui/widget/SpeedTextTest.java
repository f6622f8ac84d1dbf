package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

class SpeedTextTest {

    private static final Vector3d ALONG_Z = new Vector3d(0, 0, 1);

    @ParameterizedTest
    @CsvSource({
        "0.97, BETA, 0.97",
        ".5 c, BETA, 0.5",
        "99.5 %, BETA, 0.995",
        "beta=10%, BETA, 0.1",
        "97% c, BETA, 0.97",
        "+9.7e1%, BETA, 0.97",
        "beta 0.6, BETA, 0.6",
        "gamma 10, GAMMA, 10",
        "gamma=10, GAMMA, 10",
        "\u03b3 = 2.5, GAMMA, 2.5",
        "rapidity 2, RAPIDITY, 2",
        "1-1e-9, ONE_MINUS_BETA, 1e-9",
        "1 \u2212 0.25, ONE_MINUS_BETA, 0.25",
        "1-beta 1e-3, ONE_MINUS_BETA, 1e-3",
        "oneMinusBeta 1e-3, ONE_MINUS_BETA, 1e-3",
    })
    void speedsAreReadAsPeopleWriteThem(String text, SpeedScale scale, double value) {
        Velocity velocity = SpeedText.parse(text, SpeedScale.BETA, ALONG_Z);
        assertThat(velocity.scale()).isEqualTo(scale);
        assertThat(velocity.value()).isEqualTo(value);
    }

    @Test
    void aBareNumberIsReadOnTheScaleThatIsShown() {
        assertThat(SpeedText.parse("60%", SpeedScale.GAMMA, ALONG_Z).speed()).isEqualTo(0.6);
        assertThat(SpeedText.parse("10", SpeedScale.GAMMA, ALONG_Z).speed()).isCloseTo(Math.sqrt(0.99), within(1e-15));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "1.2",
                "-0.1",
                "gamma 0.5",
                "warp 9",
                "",
                "fast",
                "0,97",
                "rapidity -1",
                "101%",
                "-5%",
                "%",
                "1e-2147483647%"
            })
    void whatIsNoSpeedIsRefusedWithAMessage(String text) {
        assertThatThrownBy(() -> SpeedText.parse(text, SpeedScale.BETA, ALONG_Z))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("must be");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0,97", "gamma 2,5", "1-0,1"})
    void aDecimalCommaIsNamed(String text) {
        assertThatThrownBy(() -> SpeedText.parse(text, SpeedScale.BETA, ALONG_Z))
                .hasMessageContaining("with a point, not a comma");
    }
}
