package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** No digit is shown that means nothing. */
class QuantityTest {

    @ParameterizedTest
    @CsvSource({
        "6.889227, 0.0253, 6.889",
        "6.889227, 0.0953, 6.889",
        "101.7823, 12.6, 102",
        "-1234.5, 250, -1230",
        "6.3001, 0.0253, 6.300",
        "-0.000004, 0.01, 0.000",
        "5.6e-14, 0.001, 0.0000",
        "6.889227, NaN, 6.8892",
        "6.889227, 0, 6.8892"
    })
    void digitsEndWhereTheUncertaintyDoes(double value, double uncertainty, String shown) {
        assertThat(new Quantity("angle", "", "degrees", value, uncertainty).text(5))
                .isEqualTo(shown);
    }

    /** What a formula gives: an exact 2 stays a 2. */
    @ParameterizedTest
    @CsvSource({
        "1.333333, 0.003, 1.3333",
        "3.4509, 0.0005, 3.4509",
        "2, 0.01, 2",
        "-2.92, 0.0005, -2.92",
        "6561, 0.5, 6561",
        "2522, 70, 2522",
        "0, 0.000001, 0",
        "1.333333, 0, 1.333333"
    })
    void aFormulaHasNoMoreDigitsThanItsTolerance(double value, double tolerance, String shown) {
        assertThat(new Quantity("", "", "", value, tolerance).briefText()).isEqualTo(shown);
    }
}
