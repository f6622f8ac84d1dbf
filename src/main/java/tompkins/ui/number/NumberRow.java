package tompkins.ui.number;

import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.StudioPath;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;
import tompkins.ui.widget.Wording;

/** One number of the studio: its name, a slider and a field. It follows the studio. */
public final class NumberRow {

    /**
     * A number of the studio.
     *
     * @param property the name of the property
     * @param tip its meaning, unit and range
     * @param reading its value, which may be infinite; NaN where the studio has no such number
     * @param change makes the studio that has another value, or throws
     * @param range where its slider runs
     */
    public record Quantity(
            String property,
            String tip,
            ToDoubleFunction<Studio> reading,
            BiFunction<Studio, Double, Studio> change,
            Function<Studio, Range> range) {

        /**
         * A number of the camera.
         *
         * @param way the way to it from the camera, such as {@code stereo.eyeDistance}
         * @param tip its meaning, unit and range
         * @param range where its slider runs, by the studio and the present value
         */
        public static Quantity ofCamera(String way, String tip, BiFunction<Studio, Double, Range> range) {
            StudioNumber number =
                    new StudioNumber(StudioPath.parse("camera." + way).orElseThrow());
            ToDoubleFunction<Studio> reading = studio -> number.isIn(studio) ? number.in(studio) : Double.NaN;
            return new Quantity(
                    (String) number.path().last(),
                    tip,
                    reading,
                    number::with,
                    studio -> range.apply(studio, reading.applyAsDouble(studio)));
        }
    }

    private final StudioModel model;
    private final Quantity quantity;
    private final JLabel label;
    private final ValueSlider slider;
    private final NumberField field;

    /**
     * A row.
     *
     * @param kind which numbers the field takes
     * @param note where messages go
     */
    public NumberRow(StudioModel model, Quantity quantity, NumberKind kind, Note note) {
        this.model = model;
        this.quantity = quantity;
        String title = Wording.label(quantity.property);
        label = new JLabel(title);
        Naming.tip(label, quantity.tip);
        slider = new ValueSlider(
                Texts.get("slider.name", title),
                quantity.tip,
                quantity.range.apply(model.studio()),
                (value, gesture) -> note.attempt(() -> model.adjust(changed(value), gesture)),
                model::endGesture);
        field = new NumberField(
                kind, quantity.property, title, quantity.tip, note, value -> model.set(changed(value.doubleValue())));
        label.setLabelFor(field.field());
        model.follow(this::update);
    }

    private Studio changed(double value) {
        return quantity.change.apply(model.studio(), value);
    }

    private void update() {
        double value = quantity.reading.applyAsDouble(model.studio());
        boolean there = !Double.isNaN(value);
        label.setEnabled(there);
        slider.slider().setEnabled(there);
        slider.setRange(quantity.range.apply(model.studio()));
        slider.show(value);
        field.show(value);
        field.setEnabled(there);
    }

    /** Adds the row to a panel of {@link Rows}. */
    public void addTo(JPanel panel) {
        panel.add(label);
        panel.add(slider.slider(), "growx, wmin 40");
        panel.add(field.field());
    }

    /** Puts a drawing before the name. */
    public void setIcon(Icon icon) {
        label.setIcon(icon);
    }
}
