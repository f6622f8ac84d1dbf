package tompkins.lesson;

import tompkins.property.InvalidPropertyException;

/** Checks of the texts of lessons: each must say something and fit into the window. */
final class LessonText {

    private LessonText() {}

    /** A text that is not blank and not longer than a number of letters. */
    static String required(String property, String text, int longest) {
        if (text.isBlank()) {
            throw new InvalidPropertyException(property, "a text", "empty");
        }
        return optional(property, text, longest);
    }

    /** A text that may be empty and is not longer than a number of letters. */
    static String optional(String property, String text, int longest) {
        int letters = text.codePointCount(0, text.length());
        if (letters > longest) {
            throw new InvalidPropertyException(
                    property, "at most " + longest + " letters long, to fit beside the picture", letters);
        }
        return text;
    }
}
