package tompkins.ui.panel;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.experiment.LessonResult;
import tompkins.lesson.LessonNumber;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Paragraph;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The last page of a lesson: what was measured in its picture, beside what the formulas say. */
final class LessonNumbersPage {

    private static final int DIGITS = 6;

    /** The digits of an error, which is known less exactly. */
    private static final int ERROR_DIGITS = 2;

    private final JPanel panel = Rows.column();
    private final JPanel table = Rows.of("wrap 5, gap 16 3", "[grow 55,fill][grow 45,fill][pref!][pref!][pref!]");
    private final Note note = new Note("");

    /** An empty page. */
    LessonNumbersPage() {
        panel.add(table, "wmin 0");
        panel.add(note.component(), "wmin 0");
    }

    /** The page itself. */
    JComponent component() {
        return panel;
    }

    /** Shows what was measured. */
    void show(List<LessonResult> results) {
        table.removeAll();
        for (String heading : List.of("number", "formula", "value", "measured", "error")) {
            add(Texts.get("lesson." + heading));
        }
        for (LessonResult result : results) {
            LessonNumber number = result.number();
            String unit = number.unit().isEmpty() ? "" : " " + number.unit();
            addWrapped(number.name());
            addWrapped(number.formula());
            add(Numbers.brief(number.value(), DIGITS) + unit);
            add(Numbers.brief(result.measured(), DIGITS) + unit);
            add(Numbers.brief(result.error(), ERROR_DIGITS));
        }
        boolean agree = results.stream().allMatch(LessonResult::agrees);
        note.setText(Texts.get(agree ? "lesson.agree" : "lesson.disagree"));
        table.revalidate();
        table.repaint();
    }

    private void addWrapped(String text) {
        table.add(new Paragraph(text).component(), "wmin 0, aligny top");
    }

    private void add(String text) {
        table.add(new JLabel(text), "aligny top");
    }

    /** Says that it is being measured. */
    void showBusy() {
        table.removeAll();
        table.repaint();
        note.setText(Texts.get("lesson.measuring"));
    }

    /** Says why nothing could be measured. */
    void showProblem(String message) {
        table.removeAll();
        table.repaint();
        note.setError(message);
    }
}
