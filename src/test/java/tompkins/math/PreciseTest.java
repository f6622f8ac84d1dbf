package tompkins.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PreciseTest {

    /** Also near half way between two doubles, where a wrong last digit would show. */
    @Test
    void decimalNumbersAreTheNearestDoublesOrLeftOpen() {
        SplittableRandom random = new SplittableRandom(1);
        int open = 0;
        for (int i = 0; i < 100_000; i++) {
            int power = -random.nextInt(1 - Precise.LEAST_POWER);
            long digits = random.nextLong(1L << random.nextInt(1, 63));
            if (i % 2 == 0) {
                double low = new BigDecimal(digits).scaleByPowerOfTen(power).doubleValue();
                BigDecimal sum = new BigDecimal(low).add(new BigDecimal(Math.nextUp(low)));
                digits = sum.divide(BigDecimal.valueOf(2))
                        .scaleByPowerOfTen(-power)
                        .longValue();
            }
            double found = Precise.decimal(digits, power);
            open += Double.isNaN(found) ? 1 : 0;
            if (!Double.isNaN(found)) {
                assertThat(found).as("%d e%d", digits, power).isEqualTo(Double.parseDouble(digits + "e" + power));
            }
        }
        assertThat(open).as("exactly half way").isBetween(1, 20_000);
    }

    @ParameterizedTest
    @CsvSource({"9007199254740993, 0", "1, 1", "1, -23"})
    void whatTwiceThePrecisionDoesNotTellIsLeftOpen(long digits, int power) {
        assertThat(Precise.decimal(digits, power)).isNaN();
    }

    @ParameterizedTest
    @CsvSource({"0, -5, 0", "5, -1, 0.5", "1, -22, 1e-22", "12345678901234567, -16, 1.2345678901234567"})
    void plainNumbersAreRead(long digits, int power, double value) {
        assertThat(Precise.decimal(digits, power)).isEqualTo(value);
    }
}
