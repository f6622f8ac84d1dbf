package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class PhotographInfoTest {

    @Test
    void refusesASceneThatIsTooLong() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new PhotographInfo("", "", "{" + " ".repeat(PhotographInfo.LONGEST_SCENE)))
                .withMessage("scene must be at most 16777216 characters long, with its pictures, to travel inside a"
                        + " photograph, was 16777217");
    }

    @Test
    void escapesAreUndoneOnlyWhereTheyWereMade() {
        String json = "{\"β\": \"\\\\u03b2 \\u0001 \\\\\\u0001 \uD835\uDEFD \u007f\"}";

        String ascii = AsciiText.escape(json);

        assertThat(ascii).isEqualTo("{\"\\u03b2\": \"\\\\u03b2 \\u0001 \\\\\\u0001 \\ud835\\udefd \\u007f\"}");
        assertThat(AsciiText.unescape(ascii)).isEqualTo(json);
    }
}
