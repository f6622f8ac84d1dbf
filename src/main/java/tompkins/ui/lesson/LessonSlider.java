package tompkins.ui.lesson;

import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.lesson.LessonControl;
import tompkins.measure.LessonStudio;
import tompkins.studio.StudioNumber;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;

/** The one number that a lesson lets its readers move. */
final class LessonSlider extends Part {

    private final ValueSlider slider;
    private final NumberField field;
    private final StudioModel model;
    private final StudioNumber number;
    private final LessonControl control;

    /** A slider for a lesson that fits its studio. */
    LessonSlider(StudioModel model, LessonStudio lesson) {
        super(Rows.column());
        this.model = model;
        number = lesson.number();
        control = lesson.lesson().control();
        Note note = new Note("");
        String tip = Texts.get("lesson.sliderTip");
        slider = new ValueSlider(
                Texts.get("slider.name", control.name()),
                tip,
                Range.even(control.from(), control.to()),
                (value, gesture) -> note.attempt(() -> model.adjust(number.with(model.studio(), value), gesture)),
                model::endGesture);
        field = new NumberField(
                NumberKind.DOUBLE,
                control.name(),
                control.name(),
                tip,
                note,
                value -> model.set(number.with(model.studio(), value.doubleValue())));
        JLabel label = new JLabel(control.name());
        label.setLabelFor(field.field());
        JPanel row = Rows.of("gap 8 2", "[grow,fill][pref!]");
        row.add(label, "span, wrap");
        row.add(slider.slider(), "wmin 60");
        row.add(field.field());
        panel.add(row, "wmin 0");
        panel.add(note.component(), "wmin 0");
        update();
    }

    /** Whether the studio has the number; it may have lost it with its object. */
    boolean isThere() {
        return number.isIn(model.studio());
    }

    /** Shows the number of the studio, if it is there. */
    void update() {
        boolean there = isThere();
        slider.slider().setEnabled(there);
        field.setEnabled(there);
        if (there && isReached()) {
            slider.show(number.in(model.studio()));
            field.show(number.in(model.studio()));
        }
    }

    /** Whether the number, if it is there, lies on the slider. */
    boolean isReached() {
        double now = isThere() ? number.in(model.studio()) : control.from();
        return now >= control.from() && now <= control.to();
    }

    /** Lets the keys move the slider. */
    void takeKeys() {
        slider.slider().requestFocusInWindow();
    }

    /** Whether the number is not that with which the lesson was opened. */
    boolean isMoved() {
        return isThere() && (!number.isIn(model.opened()) || number.in(model.studio()) != number.in(model.opened()));
    }
}
