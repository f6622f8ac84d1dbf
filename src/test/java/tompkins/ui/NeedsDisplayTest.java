package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** When tests of windows run, are skipped, or fail. */
class NeedsDisplayTest {

    @ParameterizedTest
    @ValueSource(strings = {"optional", "required"})
    void theyRunWithADisplay(String wanted) {
        assertThat(NeedsDisplay.Condition.decide(true, wanted).isDisabled()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"optional", ""})
    void theyAreSkippedWithoutOne(String wanted) {
        assertThat(NeedsDisplay.Condition.decide(false, wanted).isDisabled()).isTrue();
    }

    @Test
    void theyFailWithoutOneThatIsRequired() {
        assertThatThrownBy(() -> NeedsDisplay.Condition.decide(false, "required"))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("xvfb-run");
    }

    /** As after the connection of an ssh with forwarding has ended. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aDisplayThatIsDeadIsNone() {
        assertThat(DisplayProbe.answers(":4242")).isFalse();
    }
}
