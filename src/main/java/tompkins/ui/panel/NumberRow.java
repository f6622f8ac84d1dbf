package tompkins.ui.panel;

import java.util.function.DoubleFunction;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Tips;
import tompkins.ui.widget.ValueSlider;
import tompkins.ui.widget.Wording;

/** One number of the studio: its name, a slider and a field. */
final class NumberRow {

    private final JLabel label;
    private final ValueSlider slider;
    private final NumberField field;

    /**
     * A row.
     *
     * @param property the name of the property
     * @param kind which numbers the field takes
     * @param note where messages go
     * @param change makes the studio that has the number, or throws
     */
    NumberRow(
            StudioModel model,
            String property,
            NumberKind kind,
            String tip,
            Range range,
            Note note,
            DoubleFunction<Studio> change) {
        String title = Wording.label(property);
        label = new JLabel(title);
        label.setToolTipText(Tips.wrapped(tip));
        slider = new ValueSlider(
                Texts.get("slider.name", title),
                tip,
                range,
                (value, gesture) -> note.attempt(() -> model.adjust(change.apply(value), gesture)),
                model::endGesture);
        field = new NumberField(
                kind, property, title, tip, note, value -> model.set(change.apply(value.doubleValue())));
        label.setLabelFor(field.field());
    }

    /** Adds the row to a panel of {@link Rows}. */
    void addTo(JPanel panel) {
        panel.add(label);
        panel.add(slider.slider(), "growx, wmin 40");
        panel.add(field.field());
    }

    /** Puts a drawing before the name. */
    void setIcon(Icon icon) {
        label.setIcon(icon);
    }

    void setRange(Range range) {
        slider.setRange(range);
    }

    /** Shows a value, which may be infinite; NaN for none. */
    void show(double value) {
        slider.show(value);
        field.show(value);
    }

    void setEnabled(boolean enabled) {
        label.setEnabled(enabled);
        slider.slider().setEnabled(enabled);
        field.field().setEnabled(enabled);
    }
}
