package tompkins.property;

import java.util.regex.Pattern;

/** What a terminal obeys instead of showing it, such as the beginning of a colour, in texts that somebody else wrote. */
public final class ControlCharacters {

    private static final Pattern RUN = Pattern.compile("[\\p{Cc}\\u2028\\u2029]+");

    private ControlCharacters() {}

    /** The text in one line, with a space for each run of control characters and ends of lines. */
    public static String replaced(String text) {
        return RUN.matcher(text).replaceAll(" ");
    }
}
