package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

class SpeedTextTest {

    private static final Vector3d ALONG_Z = new Vector3d(0, 0, 1);

    @ParameterizedTest
    @CsvFileSource(resources = "speeds.csv", quoteCharacter = '\'')
    void speedsAreReadAsPeopleWriteThem(String text, SpeedScale scale, double value) {
        Velocity velocity = SpeedText.parse(text, SpeedScale.BETA, ALONG_Z);
        assertThat(velocity.scale()).isEqualTo(scale);
        assertThat(velocity.value()).isEqualTo(value);
    }

    /** By sqrt(2 (gamma - 1)), which rapidity and beta are at low speeds. */
    @ParameterizedTest
    @CsvSource({"gamma 1+5e-7, 1e-3", "gamma 1 + 5e-15, 1e-7"})
    void aGammaThatHardlyDiffersFromOneKeepsItsDigits(String text, double beta) {
        Velocity velocity = SpeedText.parse(text, SpeedScale.BETA, ALONG_Z);
        assertThat(velocity.speed()).isCloseTo(beta, within(1e-6 * beta));
        assertThat(velocity.gammaMinusOne()).isCloseTo(beta * beta / 2, within(1e-9 * beta * beta));
    }

    @ParameterizedTest
    @CsvFileSource(resources = "speed-texts.csv")
    void whatNobodyTypedHasFourDigits(SpeedScale typed, double value, SpeedScale scale, String text) {
        assertThat(SpeedText.of(Velocity.of(typed, value, ALONG_Z), scale)).isEqualTo(text);
    }

    /** No speed reads as that of light. */
    @ParameterizedTest
    @CsvSource({
        "0.97, '(0, 0, 0.97)'",
        "0.9999, '(0, 0, 0.9999)'",
        "0.999996, '0.999996 \u00b7 (0, 0, 1)'",
        "0.9999999, '(1-1e-7) \u00b7 (0, 0, 1)'"
    })
    void aVectorShowsHowFarItIsFromTheSpeedOfLight(double speed, String text) {
        assertThat(SpeedText.vector(Velocity.of(0, 0, speed))).isEqualTo(text);
    }

    @Test
    void aBareNumberIsReadOnTheScaleThatIsShown() {
        assertThat(SpeedText.parse("60%", SpeedScale.GAMMA, ALONG_Z).speed()).isEqualTo(0.6);
        assertThat(SpeedText.parse("10", SpeedScale.GAMMA, ALONG_Z).speed()).isCloseTo(Math.sqrt(0.99), within(1e-15));
    }

    @ParameterizedTest
    @MethodSource("noSpeeds")
    void whatIsNoSpeedIsRefusedWithAMessage(String text) {
        assertThatThrownBy(() -> SpeedText.parse(text, SpeedScale.BETA, ALONG_Z))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("must be");
    }

    static Stream<String> noSpeeds() {
        return Stream.of(("1.2;-0.1;gamma 0.5;warp 9;;fast;0,9,7;gamma 1,500"
                        + ";300000 km/s;km/s;gamma 1+-0.1;rapidity -1;101%;-5%;%;1e-2147483647%")
                .split(";"));
    }
}
