package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LatinKeysTest {

    /** From the tables of the X Window System (xkeyboard-config: ru, ua, by, gr, il, ara, ir, ge, th). */
    @ParameterizedTest
    @CsvSource({
        "\u044f, Z",
        "\u042f, Z",
        "\u044b, S",
        "\u0443, E",
        "\u0441, C",
        "\u043c, V",
        "\u0447, X",
        "\u0444, A",
        "\u0456, S",
        "\u045e, O",
        "\u03b6, Z",
        "\u03c3, S",
        "\u03b5, E",
        "\u03c2, W",
        "\u03a3, S",
        "\u03b1, A",
        "\u05d6, Z",
        "\u05d3, S",
        "\u05e7, E",
        "\u05e0, B",
        "\u05e9, A",
        "\u0626, Z",
        "\u0633, S",
        "\u062b, E",
        "\ufefb, B",
        "\u0634, A",
        "\u0638, Z",
        "\u06cc, D",
        "\u06f0, 0",
        "\u0669, 9",
        "\u10d6, Z",
        "\u0e1c, Z"
    })
    void lettersCountByTheirPlaces(char letter, char latin) {
        assertThat((char) LatinKeys.code(letter)).isEqualTo(latin);
    }

    @ParameterizedTest
    @ValueSource(chars = {'a', 'Z', '0', '/', '\'', '\u00e9', '\u00e0', '\u0301', KeyEvent.CHAR_UNDEFINED})
    void othersStay(char letter) {
        assertThat(LatinKeys.code(letter)).isEqualTo(KeyEvent.VK_UNDEFINED);
    }
}
