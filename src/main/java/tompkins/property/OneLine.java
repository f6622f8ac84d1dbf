package tompkins.property;

import java.util.Locale;
import java.util.regex.Pattern;

/** Makes foreign texts safe for one line of a terminal, which obeys control characters. */
public final class OneLine {

    /** Control characters, ends of lines, and what changes the direction in which other letters are written. */
    private static final Pattern CONTROLS =
            Pattern.compile("[\\p{Cc}\\u2028\\u2029\\u061c\\u200e\\u200f\\u202a-\\u202e\\u2066-\\u2069]+");

    /** What shows nothing, except for spaces, tabs and the ends of lines. */
    private static final Pattern INVISIBLE = Pattern.compile("[\\p{Z}\\p{Cf}\\p{Cc}&&[^ \\t\\r\\n]]");

    private OneLine() {}

    /** The text with a space for each run of such characters. */
    public static String of(String text) {
        return CONTROLS.matcher(text).replaceAll(" ");
    }

    /**
     * As above, for a text that may be wrong because of a character that nobody sees: its number is shown. A text of
     * more than {@code longest} characters is cut, and its length is added.
     */
    public static String shortened(String text, int longest) {
        boolean tooLong = text.length() > longest;
        int end = tooLong ? longest - 10 : text.length();
        // never between the two halves of one character
        String start = text.substring(0, tooLong && Character.isHighSurrogate(text.charAt(end - 1)) ? end - 1 : end);
        String seen = INVISIBLE
                .matcher(start)
                .replaceAll(found ->
                        String.format(Locale.ROOT, "<U+%04X>", found.group().codePointAt(0)));
        return of(seen) + (tooLong ? "... (" + text.length() + " characters)" : "");
    }
}
