package tompkins.ui.widget;

import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import tompkins.property.InvalidPropertyException;

/** A field for a number; the up and down keys change it by a step, with Shift by ten of them. */
public final class NumberField {

    private final NumberKind kind;
    private final Function<String, Number> reader;
    private final JTextField field = new JTextField(6);
    private final EntryField entry;
    private Number value = 0;

    /** What was typed last; null before. */
    private Number typed;

    /** A field like {@link EntryField}, for the property of the given name. */
    public NumberField(
            NumberKind kind, String property, String name, String tip, Note note, Consumer<? super Number> commit) {
        this(kind, text -> kind.parse(property, text), name, tip, note, commit);
    }

    private NumberField(
            NumberKind kind,
            Function<String, Number> reader,
            String name,
            String tip,
            Note note,
            Consumer<? super Number> commit) {
        this.kind = kind;
        this.reader = reader;
        entry = new EntryField(field, name, tip, note, text -> {
            typed = reader.apply(text);
            commit.accept(typed);
        });
        step("UP", 1);
        step("DOWN", -1);
        step("shift UP", 10);
        step("shift DOWN", -10);
    }

    /** A field for a whole number from a least to a most, which its messages name. */
    public static NumberField within(
            String property, int least, int most, String name, String tip, Note note, IntConsumer commit) {
        Function<String, Number> reader = text -> (int) Numbers.parseWhole(property, text, least, most);
        return new NumberField(NumberKind.INT, reader, name, tip, note, number -> commit.accept(number.intValue()));
    }

    private void step(String key, int steps) {
        Keys.bindFocused(field, KeyStroke.getKeyStroke(key), () -> {
            try {
                field.setText(kind.stepped(present(), steps));
            } catch (InvalidPropertyException noNumber) {
                // the message comes when the text is taken
            }
            entry.commit();
        });
    }

    /** The number in the field, whether it has been taken or not. */
    private Number present() {
        boolean isWord = !entry.isPending() && !Double.isFinite(value.doubleValue());
        return isWord ? value : reader.apply(field.getText());
    }

    /** The field itself, to be put into a panel. */
    public JTextField field() {
        return field;
    }

    /** Whether a number can be typed; one that was typed and not taken goes when that ends. */
    public void setEnabled(boolean enabled) {
        field.setEnabled(enabled);
        if (!enabled) {
            entry.revert();
        }
    }

    /** Shows a number; digits that do not fit stay in the model. */
    public void show(Number number) {
        value = number;
        entry.show(kind.text(number, number.equals(typed)));
    }
}
