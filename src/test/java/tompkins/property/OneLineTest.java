package tompkins.property;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class OneLineTest {

    @Test
    void whatMovesTheLineOfATerminalBecomesASpace() {
        assertThat(OneLine.of("one\r\n\ttwo\u001b[2J\u2028three")).isEqualTo("one two [2J three");
    }

    /** Overrides, isolates and marks turn the order of what follows them, and so hide how a name ends. */
    @Test
    void whatTurnsTheOrderOfLettersBecomesASpace() {
        for (String control :
                "\u061c \u200e \u200f \u202a \u202b \u202c \u202d \u202e \u2066 \u2067 \u2068 \u2069".split(" ")) {
            assertThat(OneLine.of("photo" + control + "gnp.exe")).isEqualTo("photo gnp.exe");
        }
        assertThat(OneLine.of("\u05d0\u0628 a\u0301 \u200d")).isEqualTo("\u05d0\u0628 a\u0301 \u200d");
    }

    @Test
    void whatShowsNothingIsShownByItsNumber() {
        assertThat(OneLine.shortened("a b\u00a0c\u200bd\ufeff", 60)).isEqualTo("a b<U+00A0>c<U+200B>d<U+FEFF>");
        assertThat(OneLine.shortened("a\n\u0000\t\u202e\u2028b", 60)).isEqualTo("a <U+0000> <U+202E><U+2028>b");
    }

    @Test
    void longTextsAreCutAndSaySo() {
        assertThat(OneLine.shortened("x".repeat(60), 60)).isEqualTo("x".repeat(60));
        assertThat(OneLine.shortened("x".repeat(61), 60)).isEqualTo("x".repeat(50) + "... (61 characters)");
        String smile = "\ud83d\ude00";
        assertThat(OneLine.shortened("x".repeat(49) + smile + "x".repeat(49), 60))
                .isEqualTo("x".repeat(49) + "... (100 characters)");
    }
}
