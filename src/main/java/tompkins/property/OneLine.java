package tompkins.property;

import java.util.regex.Pattern;

/**
 * Makes texts that somebody else wrote safe for one line of a terminal, which obeys control characters instead of
 * showing them.
 */
public final class OneLine {

    /** Control characters, ends of lines, and what changes the direction in which other letters are written. */
    private static final Pattern CONTROLS =
            Pattern.compile("[\\p{Cc}\\u2028\\u2029\\u061c\\u200e\\u200f\\u202a-\\u202e\\u2066-\\u2069]+");

    private OneLine() {}

    /** The text with a space for each run of such characters. */
    public static String of(String text) {
        return CONTROLS.matcher(text).replaceAll(" ");
    }

    /** As above; a text of more than {@code longest} characters is cut there, and its length is added. */
    public static String shortened(String text, int longest) {
        boolean tooLong = text.length() > longest;
        String start = tooLong ? text.substring(0, longest - 10) : text;
        return of(start) + (tooLong ? "... (" + text.length() + " characters)" : "");
    }
}
