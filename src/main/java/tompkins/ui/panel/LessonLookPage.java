package tompkins.ui.panel;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.experiment.LessonStudio;
import tompkins.lesson.LessonControl;
import tompkins.studio.StudioNumber;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberField;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Paragraph;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.ValueSlider;

/** The second page of a lesson: one number to move, and the picture to look at. */
final class LessonLookPage {

    private final JPanel panel = Rows.column();
    private final Paragraph answer = new Paragraph("");
    private final ValueSlider slider;
    private final NumberField field;
    private final StudioModel model;
    private final StudioNumber number;

    /** The page of a lesson that fits its studio. */
    LessonLookPage(StudioModel model, LessonStudio lesson) {
        this.model = model;
        number = lesson.number();
        LessonControl control = lesson.lesson().control();
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
        panel.add(answer.component(), "wmin 0");
        JPanel row = Rows.of("flowx, gap 8 0", "[pref!][grow,fill][pref!]");
        row.add(label);
        row.add(slider.slider(), "wmin 60");
        row.add(field.field());
        panel.add(row, "wmin 0");
        panel.add(new Paragraph(Texts.get("lesson.lookHint")).component(), "wmin 0");
        panel.add(note.component(), "wmin 0");
        update();
    }

    /** The page itself. */
    JComponent component() {
        return panel;
    }

    /** Reminds of the answer. */
    void show(LessonAnswer given) {
        answer.setText(Texts.get(
                given.sure() ? "lesson.expectedSure" : "lesson.expected",
                given.prediction().text()));
    }

    /** Shows the number of the studio; it may have lost it. */
    void update() {
        boolean there = number.isIn(model.studio());
        slider.slider().setEnabled(there);
        field.field().setEnabled(there);
        if (there) {
            slider.show(number.in(model.studio()));
            field.show(number.in(model.studio()));
        }
    }
}
