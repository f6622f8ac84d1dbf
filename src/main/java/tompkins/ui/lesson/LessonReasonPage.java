package tompkins.ui.lesson;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.Comparator;
import javax.swing.JLabel;
import tompkins.io.FactText;
import tompkins.lesson.Lesson;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The third page of a lesson: whether the prediction was right, and why it is so. */
final class LessonReasonPage extends Part {

    private final JLabel verdict = new JLabel();
    private final Note right = Note.paragraph("");
    private final Note reply = Note.paragraph("");
    private final Lesson lesson;

    /** The page of a lesson. */
    LessonReasonPage(Lesson lesson) {
        super(Rows.column());
        this.lesson = lesson;
        verdict.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        panel.add(verdict, "wmin 0");
        panel.add(right.component(), "wmin 0");
        panel.add(reply.component(), "wmin 0");
        panel.add(Note.paragraph(FactText.readable(lesson.reveal())).component(), "wmin 0");
        // as high from the beginning as it can become, so that the picture keeps its size
        lesson.predictions().stream()
                .max(Comparator.comparingInt(prediction -> prediction.reply().length()))
                .ifPresent(longest -> show(new LessonQuestionPage.Answer(longest, true)));
    }

    /** Judges an answer. */
    void show(LessonQuestionPage.Answer answer) {
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
