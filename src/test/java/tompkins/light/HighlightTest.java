package tompkins.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HighlightTest {

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 40, 63, 64, 100, 1023, 1024})
    void wholePowerIsThatOfManyDigits(int exponent) {
        for (double base : new double[] {0, 0.5, 0.3, 0.77, 0.999, 1, 1.01}) {
            double exact =
                    new BigDecimal(base).pow(exponent, new MathContext(60)).doubleValue();

            assertThat(Sightline.power(base, exponent)).isCloseTo(exact, within(exponent * 0x1p-53 * exact));
        }
    }

    @Test
    void otherPowersAreThoseOfTheLibrary() {
        assertThat(Sightline.power(0.3, 2.5)).isEqualTo(Math.pow(0.3, 2.5));
        assertThat(Sightline.power(0.999, 1e10)).isEqualTo(Math.pow(0.999, 1e10));
    }
}
