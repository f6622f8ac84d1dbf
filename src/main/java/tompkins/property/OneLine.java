package tompkins.property;

import java.util.regex.Pattern;

/**
 * Texts that somebody else wrote, fit for one line of a terminal: it obeys control characters instead of showing them.
 */
public final class OneLine {

    private static final Pattern CONTROLS = Pattern.compile("[\\p{Cc}\\u2028\\u2029]+");

    private OneLine() {}

    /** The text with a space for each run of control characters and ends of lines. */
    public static String of(String text) {
        return CONTROLS.matcher(text).replaceAll(" ");
    }

    /** As above; of a text of more characters than {@code longest} the beginning, and how many they are. */
    public static String shortened(String text, int longest) {
        boolean tooLong = text.length() > longest;
        String start = tooLong ? text.substring(0, longest - 10) : text;
        return of(start) + (tooLong ? "... (" + text.length() + " characters)" : "");
    }
}
