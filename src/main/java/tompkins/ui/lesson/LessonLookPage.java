package tompkins.ui.lesson;

import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The second page of a lesson: what was expected, and what to do with the slider below. */
final class LessonLookPage extends Part {

    private final Note answer = Note.paragraph("");
    private final Note hint = Note.paragraph("");

    /** The page; {@code flyer} flies the ride of the scene, null if it has none. */
    LessonLookPage(Runnable flyer) {
        super(Rows.column());
        panel.add(answer.component(), "wmin 0");
        panel.add(hint.component(), "wmin 0");
        if (flyer != null) {
            panel.add(Buttons.of("lesson.fly", flyer), "growx 0");
        }
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
