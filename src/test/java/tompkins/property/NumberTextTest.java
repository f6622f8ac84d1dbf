package tompkins.property;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.TestRun;
import tools.jackson.core.io.NumberOutput;

class NumberTextTest {

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, -0",
        "2, 2",
        "640.5, 640.5",
        "-0.1, -0.1",
        "1e-6, 0.000001",
        "-2.5e-5, -0.000025",
        "9.5e-7, 9.5e-7",
        "1e-9, 1e-9",
        "10000000, 10000000",
        "1e9, 1e9",
        "1234567891.5, 1.2345678915e9",
        "2e23, 2e23",
        "2.2e-322, 2.2e-322",
        "4.9e-324, 4.9e-324",
        "-9007199254740993, -9.007199254740992e15",
        "1.7976931348623157E308, 1.7976931348623157e308",
        "NaN, NaN",
        "-Infinity, -Infinity"
    })
    void numbersAreWrittenAsPeopleDo(double value, String text) {
        assertThat(NumberText.of(value)).isEqualTo(text);
        assertThat(Double.valueOf(text)).isEqualTo(Double.valueOf(value));
        assertThat(Double.valueOf(NumberText.parse(" " + text))).isEqualTo(Double.valueOf(value));
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", ".x", ",x", "e5x"})
    @Timeout(600)
    void manyDigitsThatAreNoNumberAreRefusedSoon(String end) {
        assertThatThrownBy(() -> NumberText.parse("1".repeat(10_000_000) + end))
                .isInstanceOf(NumberFormatException.class);
    }

    /**
     * Another program's way to the shortest digits; it takes other ones only at powers of two, where both are right.
     */
    @Test
    void noDigitIsWrittenThatIsNotNeeded() {
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < TestRun.cases(20_000, 100_000); i++) {
            double value = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(value) && Math.getExponent(value) >= Double.MIN_EXPONENT) {
                assertThat(new BigDecimal(NumberText.of(value)))
                        .isEqualByComparingTo(new BigDecimal(NumberOutput.toString(value, true)));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        ".5, 0.5",
        "+1., 1",
        "-.25E+2, -25",
        "007, 7",
        "'0,9', 0.9",
        "'-,5', -0.5",
        "'1,5e3', 1500",
        "'0,125', 0.125",
        "'1234,567', 1234.567",
        "'1,50', 1.5"
    })
    void numbersAreReadAsPeopleWriteThem(String text, double value) {
        assertThat(NumberText.parse(text)).isEqualTo(value);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                ".",
                "3d",
                "0.5f",
                "0x1p3",
                "1e",
                "1 2",
                "\u0663",
                "nan",
                "1,500",
                "-12,500e3",
                "1,2,3",
                "1.5,2",
                "5,"
            })
    void whatElseJavaTakesForNumbersIsNone(String text) {
        assertThatThrownBy(() -> NumberText.parse(text)).isInstanceOf(NumberFormatException.class);
    }

    @ParameterizedTest
    @CsvSource({
        "3.14159265, 3, 3.14",
        "2.5e-9, 1, 0.000000003",
        "123456789, 2, 120000000",
        "0.9999, 2, 1",
        "-0.0, 3, 0",
        "1e12, 3, 1000000000000"
    })
    void numbersAreRoundedToTheirFirstDigits(double value, int digits, String text) {
        assertThat(NumberText.plain(value, digits)).isEqualTo(text);
        assertThat(NumberText.rounded(value, digits)).isEqualTo(Double.valueOf(text));
    }

    @Test
    void whatIsNotFiniteIsNotRounded() {
        assertThat(NumberText.rounded(Double.NaN, 3)).isNaN();
        assertThat(NumberText.rounded(Double.NEGATIVE_INFINITY, 3)).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    @Test
    void refusedNumbersAreWrittenSoToo() {
        assertThatThrownBy(() -> Require.within("error", 2, 1e-6, 1))
                .hasMessage("error must be from 0.000001 to 1, was 2");
        assertThatThrownBy(() -> Require.between("angle", -1e-7, 0, 179.5))
                .hasMessage("angle must be above 0 and below 179.5, was -1e-7");
        assertThat(Require.text(new Vector3d(0.6, 0, 1e-5))).isEqualTo("[0.6, 0, 0.00001]");
    }

    @ParameterizedTest
    @CsvSource({"1e-400, true", "-0.3e-323, false", "'0.0', false", "0e-400, false", "1e5, false", "2.5E-1000, true"})
    void numbersVanishThatAreReadAsZero(String text, boolean vanishes) {
        assertThat(NumberText.vanishes(text)).isEqualTo(vanishes);
    }
}
