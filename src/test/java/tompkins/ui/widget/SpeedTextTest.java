package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

class SpeedTextTest {

    private static final Vector3d ALONG_Z = new Vector3d(0, 0, 1);

    @ParameterizedTest
    @CsvSource({
        "0.97, BETA, 0.97",
        "'0,97', BETA, 0.97",
        "'gamma 2,5', GAMMA, 2.5",
        "'99,5 %', BETA, 0.995",
        "'1-0,1', ONE_MINUS_BETA, 0.1",
        "149896.229 km/s, BETA, 0.5",
        "'149896,229km/s', BETA, 0.5",
        "149896229 m/s, BETA, 0.5",
        "beta = 1.49896229e5 km/s, BETA, 0.5",
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

    /** By sqrt(2 (gamma - 1)), which rapidity and beta are at low speeds. */
    @ParameterizedTest
    @CsvSource({"gamma 1+5e-7, 1e-3", "gamma 1 + 5e-15, 1e-7"})
    void aGammaThatHardlyDiffersFromOneKeepsItsDigits(String text, double beta) {
        Velocity velocity = SpeedText.parse(text, SpeedScale.BETA, ALONG_Z);
        assertThat(velocity.speed()).isCloseTo(beta, within(1e-6 * beta));
        assertThat(velocity.gammaMinusOne()).isCloseTo(beta * beta / 2, within(1e-9 * beta * beta));
    }

    @ParameterizedTest
    @CsvSource({
        "BETA, 0.001, GAMMA, 1+5e-7",
        "BETA, 0.01, GAMMA, 1.00005",
        "BETA, 0.6, GAMMA, 1.25",
        "BETA, 0.8, RAPIDITY, 1.099",
        "BETA, 0, GAMMA, 1",
        "GAMMA, 1.00000001, GAMMA, 1+1e-8",
        "GAMMA, 1.0001, GAMMA, 1.0001",
        "GAMMA, 10, BETA, 0.995",
        "GAMMA, 100, BETA, 0.99995",
        "GAMMA, 2, BETA, 0.866",
        "BETA, 0.1234567, BETA, 0.1234567",
        "ONE_MINUS_BETA, 1e-9, BETA, 1-1e-9",
    })
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
