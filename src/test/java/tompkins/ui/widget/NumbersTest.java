package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.within;

import java.text.BreakIterator;
import java.util.Locale;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpeedScale;

class NumbersTest {

    @ParameterizedTest
    @CsvSource({"0, 0", "-0.0, 0", "10, 10", "0.97, 0.97", "1e-9, 1e-9", "-2.5e-7, -2.5e-7", "1.5e12, 1.5e12"})
    void textsAreShortAndExact(double value, String text) {
        assertThat(Numbers.text(value)).isEqualTo(text);
        assertThat(Numbers.parse("value", text)).isEqualTo(value + 0.0);
    }

    @ParameterizedTest
    @CsvSource({
        "3.14159265, 3.142",
        "100000, 100000",
        "-0.1, -0.1",
        "1.23456e-9, 1.235e-9",
        "123456789, 123500000",
        "0, 0"
    })
    void briefTextsHaveFourDigits(double value, String text) {
        assertThat(Numbers.brief(value)).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource({
        "0.90000000000000013, 0.9",
        "0.52181175, 0.5218118",
        "1.2345678e-9, 1.2346e-9",
        "99999999.4, 99999999",
        "2, 2"
    })
    void asManyDigitsAreShownAsFit(double value, String text) {
        assertThat(Numbers.fitting(value, 9)).isEqualTo(text);
    }

    @Test
    void infinityHasASign() {
        assertThat(Numbers.brief(Double.POSITIVE_INFINITY)).isEqualTo("\u221e");
    }

    @ParameterizedTest
    @CsvSource({"0.03, 0.05", "1, 1", "1.01, 2", "12, 20", "49, 50", "51, 100", "99999, 100000"})
    void endsOfSlidersAreRoundNumbers(double value, double end) {
        assertThat(Numbers.niceCeiling(value)).isEqualTo(end);
    }

    @Test
    void anEventIsToldWithoutErrorsOfRounding() {
        assertThat(Numbers.brief(new Event(2e-12, 0, -1.279e-13, 1.326)).replace('\u00a0', ' '))
                .isEqualTo("(2e-12, 0, 0; t = 1.326)");
        assertThat(Numbers.brief(new Event(1e-20, 0, 0, 0))).startsWith("(1e-20, ");
    }

    /** Asks what text areas ask for the places where a line may end. */
    @Test
    void theTimeOfAnEventStaysOnOneLine() {
        String text = "Starts at " + Numbers.brief(new Event(1, 2, 3, 0.5));
        assertThat(text.replace('\u00a0', ' ')).isEqualTo("Starts at (1, 2, 3; t = 0.5)");

        BreakIterator lines = BreakIterator.getLineInstance(Locale.ROOT);
        lines.setText(text);

        assertThat(lines.following(text.indexOf('t', 10))).isEqualTo(text.length());
        assertThat(lines.isBoundary(text.indexOf('2'))).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {"0,9; 0.9", "-12,5; -12.5", ",5; 0.5", "0,125; 0.125", "1234,567; 1234.567", "2,5e-3; 0.0025"})
    void aCommaThatCanOnlyBeDecimalIsRead(String text, double value) {
        assertThat(Numbers.parse("radius", text)).isEqualTo(value);
    }

    /** Quotation marks around nothing are hard to see. */
    @ParameterizedTest
    @ValueSource(strings = {"", "  "})
    void anEmptyFieldIsCalledEmpty(String nothing) {
        assertThat(catchThrowable(() -> Numbers.parse("radius", nothing))).hasMessageEndingWith(", was empty");
        assertThat(catchThrowable(() -> Numbers.parseWhole("samples", nothing, 1, 9)))
                .hasMessageEndingWith(", was empty");
        assertThat(catchThrowable(() -> SpeedText.parse(nothing, SpeedScale.BETA, new Vector3d(0, 0, 1))))
                .hasMessageEndingWith(", was empty");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {"1,500; true", "-1 , 5; true", "0.9.; false", "wide, high; false"})
    void aDecimalCommaIsNamed(String text, boolean named) {
        assertThatThrownBy(() -> Numbers.parse("radius", text))
                .satisfies(refusal -> assertThat(refusal.getMessage().contains("with a point, not a comma"))
                        .isEqualTo(named));
    }

    @Test
    void slidersReachTheirEndsAndComeBack() {
        for (Range range :
                new Range[] {Range.even(-20, 20), new Range(0, 0.5, 2), new Range(1, 256, 4), Range.speeds(0.995)}) {
            assertThat(range.value(0)).isEqualTo(range.minimum());
            assertThat(range.value(1)).isEqualTo(range.maximum());
            for (double position = 0; position <= 1; position += 0.125) {
                assertThat(range.position(range.value(position))).isCloseTo(position, within(0.03));
            }
            assertThat(range.position(range.maximum() * 7)).isEqualTo(1);
        }
    }
}
