package tompkins.ui;

import java.awt.event.ActionEvent;
import java.util.function.DoubleConsumer;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import tompkins.property.NumberText;

/** A field for a number; the up and down keys change it by a step of its last digits, with Shift by ten of them. */
final class NumberField {

    private static final double STEP = 0.01;
    private static final int DIGITS = 7;

    private final EntryField entry;
    private double value;

    /** A field as {@link EntryField}, for the property of the given name. */
    NumberField(String property, String name, String tip, Note note, DoubleConsumer commit) {
        entry = new EntryField(name, tip, note, text -> commit.accept(Numbers.parse(property, text)));
        entry.field().setColumns(6);
        step("UP", 1);
        step("DOWN", -1);
        step("shift UP", 10);
        step("shift DOWN", -10);
    }

    private void step(String key, int steps) {
        field().getInputMap().put(KeyStroke.getKeyStroke(key), key);
        field().getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                double size = value == 0 ? 1 : Math.pow(10, Math.floor(Math.log10(Math.abs(value))));
                entry.field().setText(Numbers.text(NumberText.rounded(value + steps * size * STEP, 6)));
                entry.commit();
            }
        });
    }

    JTextField field() {
        return entry.field();
    }

    /** Shows a number; the digits that do not fit stay in the model. */
    void show(double number) {
        value = number;
        entry.show(Numbers.text(NumberText.rounded(number, DIGITS)));
    }
}
