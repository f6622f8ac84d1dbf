package tompkins.ui.panel;

import com.formdev.flatlaf.FlatClientProperties;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.lesson.Lesson;
import tompkins.ui.widget.Paragraph;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The third page of a lesson: whether the prediction was right, and why it is so. */
final class LessonReasonPage {

    private final JPanel panel = Rows.column();
    private final JLabel verdict = new JLabel();
    private final Paragraph right = new Paragraph("");
    private final Paragraph reply = new Paragraph("");
    private final Lesson lesson;

    /** The page of a lesson. */
    LessonReasonPage(Lesson lesson) {
        this.lesson = lesson;
        verdict.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        panel.add(verdict, "wmin 0");
        panel.add(right.component(), "wmin 0");
        panel.add(reply.component(), "wmin 0");
        panel.add(new Paragraph(lesson.reveal()).component(), "wmin 0");
    }

    /** The page itself. */
    JComponent component() {
        return panel;
    }

    /** Judges an answer. */
    void show(LessonAnswer answer) {
        boolean isRight = lesson.isRight(answer.prediction());
        verdict.setText(Texts.get("lesson." + (isRight ? "right" : "wrong") + (answer.sure() ? "Sure" : "")));
        right.setText(
                isRight
                        ? ""
                        : Texts.get(
                                "lesson.rightIs",
                                lesson.predictions().get(lesson.right() - 1).text()));
        reply.setText(answer.prediction().reply());
    }
}
