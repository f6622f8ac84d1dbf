package tompkins.ui.lesson;

import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The second page of a lesson: one number to move, and the picture to look at. */
final class LessonLookPage extends Part {

    private final Note answer = Note.paragraph("");
    private final Note hint = Note.paragraph("");

    /** The page with the slider of a lesson. */
    LessonLookPage(LessonSlider slider) {
        super(Rows.column());
        panel.add(answer.component(), "wmin 0");
        panel.add(slider.component(), "wmin 0");
        panel.add(hint.component(), "wmin 0");
        update(slider.isThere());
    }

    /** Says what to do with the slider, or that the scene has lost what it moves. */
    void update(boolean there) {
        if (there) {
            hint.setText(Texts.get("lesson.lookHint"));
        } else {
            hint.setError(Texts.get("lesson.lost"));
        }
    }

    /** Reminds of the answer. */
    void show(LessonQuestionPage.Answer given) {
        answer.setText(Texts.get(
                given.sure() ? "lesson.expectedSure" : "lesson.expected",
                given.prediction().text()));
    }
}
