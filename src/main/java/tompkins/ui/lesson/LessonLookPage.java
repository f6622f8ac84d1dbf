package tompkins.ui.lesson;

import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The second page of a lesson: one number to move, and the picture to look at. */
final class LessonLookPage extends Part {

    private final Note answer = Note.paragraph("");

    /** The page with the slider of a lesson. */
    LessonLookPage(LessonSlider slider) {
        super(Rows.column());
        panel.add(answer.component(), "wmin 0");
        panel.add(slider.component(), "wmin 0");
        panel.add(Note.paragraph(Texts.get("lesson.lookHint")).component(), "wmin 0");
    }

    /** Reminds of the answer. */
    void show(LessonQuestionPage.Answer given) {
        answer.setText(Texts.get(
                given.sure() ? "lesson.expectedSure" : "lesson.expected",
                given.prediction().text()));
    }
}
