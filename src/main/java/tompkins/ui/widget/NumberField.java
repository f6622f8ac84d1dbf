package tompkins.ui.widget;

import java.awt.event.ActionEvent;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import tompkins.property.InvalidPropertyException;

/** A field for a number; the up and down keys change it by a step, with Shift by ten of them. */
public final class NumberField {

    private final NumberKind kind;
    private final String property;
    private final JTextField field = new JTextField(6);
    private final EntryField entry;
    private Number value = 0;

    /** A field as {@link EntryField}, for the property of the given name. */
    public NumberField(
            NumberKind kind, String property, String name, String tip, Note note, Consumer<? super Number> commit) {
        this.kind = kind;
        this.property = property;
        entry = new EntryField(field, name, tip, note, text -> commit.accept(kind.parse(property, text)));
        step("UP", 1);
        step("DOWN", -1);
        step("shift UP", 10);
        step("shift DOWN", -10);
    }

    private void step(String key, int steps) {
        field.getInputMap().put(KeyStroke.getKeyStroke(key), key);
        field.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                try {
                    field.setText(kind.stepped(present(), steps));
                } catch (InvalidPropertyException noNumber) {
                    // which is said when it is to be taken
                }
                entry.commit();
            }
        });
    }

    /** The number in the field: what was typed there last, though it may not have been taken. */
    private Number present() {
        return entry.isPending() ? kind.parse(property, field.getText()) : value;
    }

    /** The field itself, to be put into a panel. */
    public JTextField field() {
        return field;
    }

    /** Shows a number; the digits that do not fit stay in the model. */
    public void show(Number number) {
        value = number;
        entry.show(kind.text(number));
    }
}
