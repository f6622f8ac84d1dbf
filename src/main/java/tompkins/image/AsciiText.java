package tompkins.image;

import java.util.HexFormat;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * JSON in formats that hold ASCII only: other letters become the escapes that JSON has for them, so that the text stays
 * JSON with the same meaning.
 */
public final class AsciiText {

    /** An escape of JSON; an escaped backslash is matched first, so that what follows it is not taken for an escape. */
    private static final Pattern ESCAPE = Pattern.compile("\\\\(\\\\|u[0-9a-fA-F]{4})");

    private AsciiText() {}

    /** Each character beyond ASCII as the escape of JSON: a backslash, the letter u and four hexadecimal digits. */
    public static String escape(String text) {
        StringBuilder ascii = new StringBuilder(text.length() + 16);
        for (int i = 0; i < text.length(); i++) {
            char letter = text.charAt(i);
            if (letter < 0x7f) {
                ascii.append(letter);
            } else {
                ascii.append("\\u").append(HexFormat.of().toHexDigits(letter));
            }
        }
        return ascii.toString();
    }

    /** The inverse; escapes of ASCII characters are the text's own and stay. */
    static String unescape(String ascii) {
        return ESCAPE.matcher(ascii).replaceAll(match -> Matcher.quoteReplacement(original(match.group())));
    }

    private static String original(String escape) {
        if (escape.length() != 6) {
            return escape;
        }
        char letter = (char) Integer.parseInt(escape.substring(2), 16);
        return letter < 0x7f ? escape : String.valueOf(letter);
    }
}
