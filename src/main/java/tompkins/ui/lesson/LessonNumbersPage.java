package tompkins.ui.lesson;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.io.FactText;
import tompkins.lesson.LessonNumber;
import tompkins.measure.LessonResult;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The last page of a lesson: what was measured in its picture, beside what the formulas say. */
final class LessonNumbersPage extends Part {

    private final JPanel table = Rows.of("wrap 4, gap 12 3", "[grow 60,fill][grow 40,fill][pref!][pref!]");
    private final Note note = new Note("");

    /** An empty page. */
    LessonNumbersPage() {
        super(Rows.column());
        panel.add(table, "wmin 0");
        panel.add(note.component(), "wmin 0");
    }

    /** Shows what was measured. */
    void show(List<LessonResult> results) {
        table.removeAll();
        for (String heading : List.of("number", "formula", "value", "measured")) {
            add(Texts.get("lesson." + heading), "");
        }
        for (LessonResult result : results) {
            LessonNumber number = result.number();
            addWrapped(number.name());
            addWrapped(readable(number.formula()));
            add(result.predictedText() + FactText.SIGNS.unit(number.unit()), "");
            add(FactText.SIGNS.value(result.told()), "font: $large.font");
        }
        boolean agree = results.stream().allMatch(LessonResult::agrees);
        note.setText(Texts.get(agree ? "lesson.agree" : "lesson.disagree"));
        table.revalidate();
        table.repaint();
    }

    private void addWrapped(String text) {
        table.add(Note.paragraph(text).component(), "wmin 0, aligny top");
    }

    /** A formula with the signs of printed ones. */
    static String readable(String formula) {
        return formula.replace("sqrt", "\u221a").replace('-', '\u2212');
    }

    private void add(String text, String style) {
        JLabel label = new JLabel(text);
        label.putClientProperty(FlatClientProperties.STYLE, style);
        table.add(label, "aligny top");
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
