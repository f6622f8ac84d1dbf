package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import tompkins.property.InvalidPropertyException;
import tompkins.ui.LightLook;

/** A field whose value may change elsewhere while something is typed. */
@LightLook
class EntryFieldTest {

    private final JTextField text = new JTextField();
    private int value = 1;
    private final EntryField field = new EntryField(text, "name", "tip", new Note(""), this::take);

    private void take(String typed) {
        try {
            value = Integer.parseInt(typed.strip());
        } catch (NumberFormatException wrong) {
            throw new InvalidPropertyException("value", "must be a whole number", typed);
        }
        show();
    }

    private void show() {
        field.show(Integer.toString(value));
    }

    @Test
    void whatIsUnfinishedStaysWhenSomethingElseChanges() {
        show();
        text.setText("12");
        show();
        assertThat(text.getText()).isEqualTo("12");
        assertThat(field.isPending()).isTrue();
        field.commit();
        assertThat(value).isEqualTo(12);
        assertThat(field.isPending()).isFalse();
    }

    @Test
    void aValueThatChangesElsewhereIsShown() {
        show();
        text.setText("12");
        value = 3;
        show();
        assertThat(text.getText()).isEqualTo("3");
        assertThat(field.isPending()).isFalse();
    }

    @Test
    void whatWasTakenIsShownAsTheValueIsWritten() {
        show();
        text.setText(" 1 ");
        field.commit();
        assertThat(text.getText()).isEqualTo("1");
        text.setText(" 5 ");
        field.commit();
        assertThat(text.getText()).isEqualTo("5");
        assertThat(field.isPending()).isFalse();
    }

    @Test
    void whatWasRefusedStaysUntilItIsTakenBack() {
        show();
        text.setText("many");
        field.commit();
        show();
        assertThat(text.getText()).isEqualTo("many");
        field.revert();
        assertThat(text.getText()).isEqualTo("1");
        assertThat(field.isPending()).isFalse();
    }
}
