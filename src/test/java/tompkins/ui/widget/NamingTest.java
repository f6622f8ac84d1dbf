package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import javax.accessibility.AccessibleContext;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;

class NamingTest {

    private final JButton button = new JButton("+");
    private final AccessibleContext accessible = button.getAccessibleContext();

    @Test
    void screenReadersHearWhatTheMouseSees() {
        String tip = "a tip with < and & that is so long that it stands on more than one line";
        Naming.name(button, "More", tip);
        assertThat(button.getName()).isEqualTo("More");
        assertThat(accessible.getAccessibleName()).isEqualTo("More");
        assertThat(button.getToolTipText()).startsWith("<html>").contains("&lt; and &amp;");
        assertThat(accessible.getAccessibleDescription()).as("without markup").isEqualTo(tip);
    }

    @Test
    void withoutMeaningThereIsNoTooltip() {
        Naming.name(button, "More", "");
        assertThat(button.getToolTipText()).isNull();
    }
}
