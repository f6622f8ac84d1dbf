package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LatinKeysTest {

    /** From the tables of the X Window System (xkeyboard-config: ru, ua, by, gr, il, ara, ir, ge, th). */
    @Test
    void lettersCountByTheirPlaces() {
        String letters =
                "\u044f\u042f\u044b\u0443\u0441\u043c\u0447\u0444\u0456\u045e\u03b6\u03c3\u03b5\u03c2\u03a3\u03b1"
                        + "\u05d6\u05d3\u05e7\u05e0\u05e9\u0626\u0633\u062b\ufefb\u0634\u0638\u06cc\u06f0\u0669\u10d6\u0e1c";
        assertThat(letters.chars().map(letter -> LatinKeys.code((char) letter)).mapToObj(Character::toString))
                .containsExactly("ZZSECVXASOZSEWSAZSEBAZSEBAZD09ZZ".split(""));
    }

    @ParameterizedTest
    @ValueSource(chars = {'a', 'Z', '0', '/', '\'', '\u00e9', '\u00e0', '\u0301', KeyEvent.CHAR_UNDEFINED})
    void othersStay(char letter) {
        assertThat(LatinKeys.code(letter)).isEqualTo(KeyEvent.VK_UNDEFINED);
    }
}
