package tompkins.ui.lesson;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.FontMetrics;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.io.FactText;
import tompkins.lesson.LessonNumber;
import tompkins.measure.LessonResult;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The last page of a lesson: what was measured in its picture, beside what the formulas say. */
final class LessonNumbersPage extends Part {

    /** Room that a text wants beside its words. */
    private static final int CARET = 2;

    private final JPanel table = Rows.of("wrap 4, gap 12 3", "");
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
        List<LessonNumber> numbers = results.stream().map(LessonResult::number).toList();
        int name = widest(numbers.stream().map(LessonNumber::name));
        int formula = widest(numbers.stream().map(number -> FactText.readable(number.formula())));
        // where not all have room, both give up the same share
        String columns = String.format(
                Locale.ROOT,
                "[0:%1$dpx:,grow,fill,shrink %1$d][0:%2$dpx:%2$dpx,fill,shrink %2$d][pref!][pref!]",
                name,
                formula);
        ((MigLayout) table.getLayout()).setColumnConstraints(columns);
        for (String heading : List.of("number", "formula", "value", "measured")) {
            add(Texts.get("lesson." + heading), "");
        }
        for (LessonResult result : results) {
            LessonNumber number = result.number();
            addWrapped(FactText.readable(number.name()));
            addWrapped(unbroken(number.formula()));
            add(FactText.readable(result.predictedText()) + FactText.SIGNS.unit(number.unit()), "");
            add(FactText.readable(FactText.SIGNS.value(result.told())), "font: $large.font");
        }
        boolean agree = results.stream().allMatch(LessonResult::agrees);
        note.setText(Texts.get(agree ? "lesson.agree" : "lesson.disagree"));
        table.revalidate();
        table.repaint();
    }

    private int widest(Stream<String> texts) {
        FontMetrics metrics = table.getFontMetrics(UIManager.getFont("Label.font"));
        return texts.mapToInt(metrics::stringWidth).max().orElse(0) + CARET;
    }

    private void addWrapped(String text) {
        table.add(Note.paragraph(text).component(), "wmin 0, aligny top");
    }

    /** A formula that breaks into lines outside of its parentheses only. */
    static String unbroken(String formula) {
        StringBuilder text = new StringBuilder(FactText.readable(formula));
        int depth = 0;
        for (int i = 0; i < text.length(); i++) {
            char sign = text.charAt(i);
            depth += sign == '(' ? 1 : sign == ')' ? -1 : 0;
            if (sign == ' ' && depth > 0) {
                text.setCharAt(i, '\u00a0');
            }
        }
        return text.toString();
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
        note.setError(Texts.get("lesson.unmeasured", message));
    }
}
