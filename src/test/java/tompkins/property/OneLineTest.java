package tompkins.property;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class OneLineTest {

    @Test
    void whatMovesTheLineOfATerminalBecomesASpace() {
        assertThat(OneLine.of("one\r\n\ttwo\u001b[2J\u2028three")).isEqualTo("one two [2J three");
    }

    @Test
    void longTextsAreCutAndSaySo() {
        assertThat(OneLine.shortened("x".repeat(60), 60)).isEqualTo("x".repeat(60));
        assertThat(OneLine.shortened("x".repeat(61), 60)).isEqualTo("x".repeat(50) + "... (61 characters)");
    }
}
