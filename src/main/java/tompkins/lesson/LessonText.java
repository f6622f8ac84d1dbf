package tompkins.lesson;

import tompkins.property.InvalidPropertyException;
import tompkins.property.Require;

/** Checks of the texts of lessons: each has something to say, and room in the window. */
final class LessonText {

    private LessonText() {}

    /** A text that is not blank and has at most so many letters. */
    static String required(String property, String text, int longest) {
        Require.present(property, text);
        if (text.isBlank()) {
            throw new InvalidPropertyException(property, "a text", "empty");
        }
        return optional(property, text, longest);
    }

    /** A text, or none, that has at most so many letters. */
    static String optional(String property, String text, int longest) {
        Require.present(property, text);
        if (text.length() > longest) {
            throw new InvalidPropertyException(
                    property, "at most " + longest + " letters long, to fit beside the picture", text.length());
        }
        return text;
    }
}
