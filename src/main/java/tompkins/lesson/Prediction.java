package tompkins.lesson;

import tompkins.property.Meaning;

/** One of the answers that a lesson offers. */
@Meaning("One of the answers to choose from")
public record Prediction(
        @Meaning("What is expected, at most 110 letters") String text,

        @Meaning(
                value = "What to say at the end to those who chose it, at most 200 letters; may be empty",
                prose = true)
        String reply) {

    /** The prediction with which a new one begins. */
    public static final Prediction DEFAULT = new Prediction("Something else.", "");

    private static final int LONGEST_TEXT = 110;
    private static final int LONGEST_REPLY = 200;

    /** Checks both texts. */
    public Prediction {
        LessonText.required("text", text, LONGEST_TEXT);
        LessonText.optional("reply", reply, LONGEST_REPLY);
    }
}
