package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.accessibility.AccessibleContext;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
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
        assertThat(button.getToolTipText())
                .isEqualTo("a tip with < and & that is so long that it stands on more\nthan one line");
        assertThat(accessible.getAccessibleDescription()).as("without markup").isEqualTo(tip);
    }

    /** The names begin with other letters than what the items write of themselves. */
    @Test
    void aLetterChoosesTheNextItemWithThatName() {
        JComboBox<Integer> numbers = new JComboBox<>(new Integer[] {1, 2, 3, 10});
        Map<Integer, String> names = Map.of(1, "One", 2, "Two", 3, "Three", 10, "Ten");
        Naming.items(numbers, names::get);
        List<Integer> chosen = new ArrayList<>();
        for (char letter : new char[] {'t', 'T', 't', 't', 'o', 'x', '3'}) {
            numbers.selectWithKeyChar(letter);
            chosen.add((Integer) numbers.getSelectedItem());
        }
        assertThat(chosen).containsExactly(2, 3, 10, 2, 1, 1, 1);
    }

    @Test
    void aBoxWithoutAChoiceSaysWhatItIsFor() {
        JComboBox<Integer> numbers = new JComboBox<>(new Integer[] {1, 2});
        Naming.name(numbers, "Numbers", "");
        Naming.items(numbers, Integer::toBinaryString);
        JList<Integer> list = new JList<>();
        assertThat(((JLabel) numbers.getRenderer().getListCellRendererComponent(list, 2, -1, false, false)).getText())
                .isEqualTo("10");
        assertThat(((JLabel) numbers.getRenderer().getListCellRendererComponent(list, null, -1, false, false))
                        .getText())
                .isEqualTo("Numbers");
    }

    @Test
    void withoutMeaningThereIsNoTooltip() {
        Naming.name(button, "More", "");
        assertThat(button.getToolTipText()).isNull();
    }
}
