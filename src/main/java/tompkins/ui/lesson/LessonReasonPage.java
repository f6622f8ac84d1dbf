package tompkins.ui.lesson;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import tompkins.io.FactText;
import tompkins.lesson.Lesson;
import tompkins.lesson.LessonControl;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The third page of a lesson: whether the prediction was right, and why it is so. */
final class LessonReasonPage extends Part {

    private final JLabel verdict = new JLabel();
    private final Note right = Note.paragraph("");
    private final Note reply = Note.paragraph("");
    private final JToggleButton outlines = new JToggleButton(Texts.get("lesson.outlines"));
    private final JToggleButton other = new JToggleButton(Texts.get("lesson.otherPicture"));
    private final Lesson lesson;

    /**
     * The page of a lesson.
     *
     * @param empty whether the scene has nothing with an outline
     * @param outliner shows where things are now, or not
     * @param mover moves the slider of the lesson
     * @param diagram shows the ride of the scene in space and time; null if it has none
     */
    LessonReasonPage(Lesson lesson, boolean empty, Consumer<Boolean> outliner, DoubleConsumer mover, Runnable diagram) {
        super(Rows.column());
        this.lesson = lesson;
        LessonControl control = lesson.control();
        Naming.name(outlines, "lesson.outlines");
        Naming.name(other, "lesson.otherPicture");
        outlines.setVisible(!empty);
        outlines.addActionListener(event -> outliner.accept(outlines.isSelected()));
        other.addActionListener(event -> mover.accept(other.isSelected() ? control.from() : control.measuredAt()));
        verdict.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        panel.add(verdict, "wmin 0");
        panel.add(right.component(), "wmin 0");
        panel.add(reply.component(), "wmin 0");
        panel.add(Note.paragraph(FactText.readable(lesson.reveal())).component(), "wmin 0");
        JPanel pictures = Rows.of("hidemode 3, gap 4, wrap 2", "[][]");
        pictures.add(outlines);
        pictures.add(other);
        if (diagram != null) {
            pictures.add(Buttons.of("lesson.diagram", diagram));
        }
        panel.add(pictures, "wmin 0, gaptop 4");
    }

    /** Begins with the picture that the text explains. */
    void showFirst() {
        outlines.setSelected(false);
        other.setSelected(false);
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
