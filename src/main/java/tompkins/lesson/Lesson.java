package tompkins.lesson;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;

/**
 * A lesson about the picture of a scene: predict, look, learn why, measure. The picture of the file is the one that is
 * seen with the question, so it must not give the answer away.
 */
@Meaning("A lesson: a question, predictions to choose from, one number to move, an explanation, and numbers to measure")
public record Lesson(
        @Meaning(value = "What is asked before anything moves, at most 300 letters", prose = true)
        String question,

        @Meaning("The predictions to choose from, two to four")
        List<Prediction> predictions,

        @Meaning("Which prediction is right, counted from 1")
        int right,

        @Meaning("The number to move when a prediction is chosen")
        LessonControl control,

        @Meaning(value = "Why it is so, at most 450 letters", prose = true)
        String reveal,

        @Meaning(
                value = "What the formulas say, in a plain sentence of at most 160 letters; may be empty",
                prose = true)
        String law,

        @Meaning(value = "What the letters of the formulas mean, at most 200 letters; may be empty", prose = true)
        String letters,

        @Meaning("What is measured at the end, at most four numbers")
        List<LessonNumber> numbers)
        implements LessonPlan {

    /** The smallest lesson, with which a new one begins. */
    public static final Lesson DEFAULT = new Lesson(
            "What will change in the picture?",
            List.of(new Prediction("Nothing.", ""), new Prediction("Something.", "")),
            2,
            LessonControl.DEFAULT,
            "Aberration crowds the scene towards the direction of motion.",
            "",
            "",
            List.of(LessonNumber.DEFAULT));

    private static final int FEWEST_PREDICTIONS = 2;
    private static final int MOST_PREDICTIONS = 4;
    private static final int MOST_NUMBERS = 4;
    private static final int LONGEST_QUESTION = 300;
    private static final int LONGEST_REVEAL = 450;
    private static final int LONGEST_LAW = 160;
    private static final int LONGEST_LETTERS = 200;

    /** Checks that there is something to ask and one right answer, and that everything has room. */
    public Lesson {
        LessonText.required("question", question, LONGEST_QUESTION);
        predictions = Require.list("predictions", predictions);
        if (predictions.size() < FEWEST_PREDICTIONS || predictions.size() > MOST_PREDICTIONS) {
            throw new InvalidPropertyException(
                    "predictions",
                    "a list of " + FEWEST_PREDICTIONS + " to " + MOST_PREDICTIONS,
                    "a list of " + predictions.size());
        }
        if (right < 1 || right > predictions.size()) {
            throw new InvalidPropertyException(
                    "right", "the number of a prediction, from 1 to " + predictions.size(), right);
        }
        LessonText.required("reveal", reveal, LONGEST_REVEAL);
        LessonText.optional("law", law, LONGEST_LAW);
        LessonText.optional("letters", letters, LONGEST_LETTERS);
        numbers = Require.list("numbers", numbers);
        if (numbers.size() > MOST_NUMBERS) {
            throw new InvalidPropertyException(
                    "numbers", "a list of at most " + MOST_NUMBERS, "a list of " + numbers.size());
        }
    }

    /** The predictions in the order in which they are offered: always the same, whichever is right. */
    public List<Prediction> shuffled() {
        List<Prediction> mixed = new ArrayList<>(predictions);
        Collections.shuffle(mixed, new Random(question.hashCode() + reveal.hashCode()));
        return mixed;
    }

    /** Whether a prediction is the right one. */
    public boolean isRight(Prediction prediction) {
        return predictions.get(right - 1).equals(prediction);
    }
}
