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
}
