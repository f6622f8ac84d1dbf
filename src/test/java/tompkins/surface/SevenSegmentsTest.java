package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SevenSegmentsTest {

    /** The middles of the segments, in the order of their usual names from a to g. */
    private static final double[][] MIDDLES = {
        {0, 0.5}, {0.25, 0.25}, {0.25, -0.25}, {0, -0.5}, {-0.25, -0.25}, {-0.25, 0.25}, {0, 0}
    };

    private static String lit(double number, double middle) {
        StringBuilder names = new StringBuilder();
        for (int i = 0; i < MIDDLES.length; i++) {
            if (SevenSegments.isLit(number, middle + MIDDLES[i][0], MIDDLES[i][1])) {
                names.append((char) ('a' + i));
            }
        }
        return names.toString();
    }

    @ParameterizedTest
    @CsvSource({
        "0, abcdef",
        "1, bc",
        "2, abdeg",
        "3, abcdg",
        "4, bcfg",
        "5, acdfg",
        "6, acdefg",
        "7, abc",
        "8, abcdefg",
        "9, abcdfg"
    })
    void digitsHaveTheirSegments(int digit, String segments) {
        assertThat(lit(digit, 0)).isEqualTo(segments);
        assertThat(lit(10 + digit, 0.35)).isEqualTo(segments);
        assertThat(lit(-digit, digit == 0 ? 0 : 0.35)).isEqualTo(segments);
    }

    /** A sign stands before a number below 0, and what has more than five characters is not shown. */
    @ParameterizedTest
    @CsvSource({"-7, -0.35, g", "-9999, -1.4, g", "99999, -1.4, abcdfg", "-10000, -1.75, ''", "100000, -1.75, ''"})
    void numbersHaveFiveCharactersAtMost(double number, double middle, String first) {
        assertThat(lit(number, middle)).isEqualTo(first);
    }
}
