package tompkins.ui.lesson;

import java.util.List;
import javax.swing.JPanel;
import tompkins.io.FactText;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonNumber;
import tompkins.measure.LessonResult;
import tompkins.property.NumberText;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The last page of a lesson: what was measured in its picture, beside what the formulas say. */
final class LessonNumbersPage extends Part {

    private final JPanel table = Rows.column();
    private final Note note = new Note("");

    /** An empty page. */
    LessonNumbersPage(Lesson lesson) {
        super(Rows.column());
        panel.add(Note.paragraph(FactText.readable(lesson.law())).component(), "wmin 0");
        panel.add(table, "wmin 0");
        panel.add(new Note(FactText.readable(lesson.letters())).component(), "wmin 0, gaptop 3");
        panel.add(note.component(), "wmin 0");
    }

    /** Shows what was measured. */
    void show(List<LessonResult> results) {
        table.removeAll();
        for (LessonResult result : results) {
            LessonNumber number = result.number();
            String unit = FactText.SIGNS.unit(number.unit());
            table.add(Note.paragraph(FactText.readable(number.name())).component(), "wmin 0, gaptop 3");
            String predicted = FactText.readable(result.predictedText()) + unit;
            add(new Note(Texts.get("lesson.predicted", predicted, FactText.readable(number.formula()))));
            String measured = FactText.readable(result.measuredText()) + unit;
            String key = result.agrees() ? "lesson.agrees" : "lesson.differs";
            add(Note.paragraph(Texts.get(key, measured, NumberText.of(number.tolerance()))));
        }
        boolean agree = results.stream().allMatch(LessonResult::agrees);
        note.setText(agree ? "" : Texts.get("lesson.disagree"));
        table.revalidate();
        table.repaint();
    }

    private void add(Note line) {
        table.add(line.component(), "wmin 0");
    }

    /** Says that it is being measured. */
    void showBusy() {
        show(List.of());
        note.setText(Texts.get("lesson.measuring"));
    }

    /** Says why nothing could be measured. */
    void showProblem(String message) {
        show(List.of());
        note.setError(Texts.get("lesson.unmeasured", message));
    }
}
