package tompkins.property;

import java.util.regex.Pattern;

/**
 * Makes texts that somebody else wrote safe for one line of a terminal, which obeys control characters instead of
 * showing them.
 */
public final class OneLine {

    private static final Pattern CONTROLS = Pattern.compile("[\\p{Cc}\\u2028\\u2029]+");

    private OneLine() {}

    /** The text with a space for each run of control characters and ends of lines. */
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
