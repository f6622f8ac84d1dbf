package tompkins.ui.lesson;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import tompkins.lesson.Lesson;
import tompkins.lesson.Prediction;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The first page of a lesson: its question, the predictions, and how sure the reader is. */
final class LessonQuestionPage extends Part {

    /**
     * What a reader answered before looking.
     *
     * @param prediction what is expected
     * @param sure whether the answer is sure
     */
    record Answer(Prediction prediction, boolean sure) {}

    private final JRadioButton sure = new JRadioButton(Texts.get("lesson.sure"));
    private final JRadioButton unsure = new JRadioButton(Texts.get("lesson.unsure"));
    private final List<JRadioButton> buttons = new ArrayList<>();
    private final Runnable answered;
    private Prediction chosen;

    /** The page of a lesson; {@code answered} is told when an answer was given, or changed. */
    LessonQuestionPage(Lesson lesson, Runnable answered) {
        super(Rows.column());
        this.answered = answered;
        panel.add(Note.paragraph(lesson.question()).component(), "wmin 0");
        ButtonGroup group = new ButtonGroup();
        JPanel answers = Rows.of("wrap 2, gap 2 3", "[pref!][grow,fill]");
        lesson.shuffled().forEach(prediction -> add(prediction, group, answers));
        panel.add(answers, "wmin 0");
        ButtonGroup sureness = new ButtonGroup();
        JPanel row = Rows.of("flowx, gap 12 0", "[pref!][pref!][grow]");
        for (JRadioButton button : new JRadioButton[] {sure, unsure}) {
            sureness.add(button);
            ChoiceRow.whenChosen(button, answered);
            row.add(button);
            buttons.add(button);
        }
        Naming.name(sure, "lesson.sure");
        Naming.name(unsure, "lesson.unsure");
        panel.add(row, "wmin 0");
    }

    private void add(Prediction prediction, ButtonGroup group, JPanel answers) {
        JRadioButton button = new JRadioButton();
        Naming.name(button, prediction.text(), Texts.get("lesson.predictionTip"));
        ChoiceRow.whenChosen(button, () -> {
            chosen = prediction;
            answered.run();
        });
        group.add(button);
        buttons.add(button);
        JComponent text = Note.paragraph(prediction.text()).component();
        text.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                if (button.isEnabled()) {
                    button.requestFocusInWindow();
                    button.setSelected(true);
                }
            }
        });
        answers.add(button);
        answers.add(text, "wmin 0");
    }

    /** The first prediction. */
    JComponent entry() {
        return buttons.get(0);
    }

    /** Takes no other answer any more: the picture has been seen. */
    void close() {
        buttons.forEach(button -> button.setEnabled(false));
    }

    /** The answer, as soon as it is complete. */
    Optional<Answer> answer() {
        return chosen == null || !(sure.isSelected() || unsure.isSelected())
                ? Optional.empty()
                : Optional.of(new Answer(chosen, sure.isSelected()));
    }
}
