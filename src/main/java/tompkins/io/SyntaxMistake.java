package tompkins.io;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.TokenStreamContext;
import tools.jackson.core.exc.UnexpectedEndOfInputException;
import tools.jackson.core.io.ContentReference;

/** Says what is wrong with a text that is not JSON, in words that help to find it. */
final class SyntaxMistake {

    private static final String NOT_JSON = "not valid JSON: ";
    private static final String VALUES = "allowed are texts in quotes, numbers, true, false, lists [ ] and objects { }";
    private static final String COMMENTS = "a comment begins with // or with /*";
    private static final String NUMBERS = "a number must be written like 0.5, -2 or 1e-9";

    private static final Pattern WRONG_BRACKET = Pattern.compile("Unexpected close marker '(.)': expected '(.)'");
    private static final Pattern WRONG_CHARACTER = Pattern.compile("Unexpected character \\('([^\\r\\n])' ");

    /** Messages of the library that name what it found, and what they mean. */
    private static final List<Map.Entry<Pattern, Function<String, String>>> WITH_FOUND = List.of(
            found("Illegal unquoted character \\(\\(CTRL-CHAR, code (\\d+)\\)\\)", SyntaxMistake::controlInText),
            found(
                    "Illegal character \\(\\(CTRL-CHAR, code (\\d+)\\)\\)",
                    code -> controlCharacter(code) + " must not stand here"),
            found(
                    "Unrecognized token '(.*?)'(:|$)",
                    word -> "unknown word " + Problems.shortened(word) + "; " + VALUES),
            found(
                    "Unrecognized character escape '(.)'",
                    letter -> "a text must not contain \\" + letter + "; a backslash itself is written \\\\"),
            found("Unrecognized character escape \\(CTRL-CHAR, code (\\d+)\\)", SyntaxMistake::escapedControl));

    private static Map.Entry<Pattern, Function<String, String>> found(String text, Function<String, String> meaning) {
        return Map.entry(Pattern.compile(text, Pattern.DOTALL), meaning);
    }

    /** Messages of the library, or parts of them, and what they mean; the first that fits counts. */
    private static final List<Map.Entry<String, String>> MEANINGS = List.of(
            Map.entry("'*' or '/' for a comment", COMMENTS),
            Map.entry("surrogate", "a text must not contain half of a character; the other half is missing"),
            Map.entry("hex-digit", "after \\u in a text there must be four digits from 0 to 9 or a to f"),
            Map.entry("double-quote to start property name", "a key must stand in double quotes"),
            Map.entry("colon to separate", "a colon must stand between a key and its value"),
            Map.entry("comma to separate", "a comma must stand between two values; it is missing before this place"),
            Map.entry("separating root-level values", JsonParsing.AFTER_THE_END),
            Map.entry("expected a valid value", "a value must stand here; " + VALUES),
            Map.entry("expected a value", "a value must stand here; " + VALUES));

    /** What the library says about numbers. */
    private static final List<String> OF_NUMBERS = List.of(
            "('.' (code 46)): expected a valid value",
            "in numeric value",
            "Invalid numeric value",
            "hexadecimal number");

    private SyntaxMistake() {}

    /** Whether the text ends where something is still missing. */
    static boolean isEndOfText(JacksonException syntax) {
        return syntax instanceof UnexpectedEndOfInputException
                || syntax.getOriginalMessage().startsWith("Unexpected end-of-input");
    }

    /**
     * Whether the text ends in a comment, or in a slash that may have been meant to begin one; the library knows only
     * the value before it.
     */
    static boolean isInComment(JacksonException syntax) {
        return syntax.getOriginalMessage().endsWith("in a comment");
    }

    /** Whether the slash at the end of a text is a single one: all comments before it are closed. */
    static boolean isSingleSlash(String text) {
        int last = text.length() - 1;
        int i = 0;
        while (i < last) {
            if (text.charAt(i) == '"') {
                i = endOfQuoted(text, i + 1);
            } else if (text.startsWith("/*", i)) {
                int end = text.indexOf("*/", i + 2);
                i = end < 0 ? text.length() : end + 2;
            } else if (text.startsWith("//", i)) {
                int end = text.indexOf('\n', i);
                i = end < 0 ? text.length() : end;
            } else {
                i++;
            }
        }
        return i == last;
    }

    /** The place after the quote that ends the text which began before a place. */
    private static int endOfQuoted(String text, int start) {
        int i = start;
        while (i < text.length() && text.charAt(i) != '"') {
            i += text.charAt(i) == '\\' ? 2 : 1;
        }
        return i + 1;
    }

    /** What is wrong with a slash that does not begin a comment. */
    static String ofSlash() {
        return NOT_JSON + COMMENTS + ", found /";
    }

    /** Whether a number is wrong; the library knows a place in it or after it. */
    static boolean isInNumber(JacksonException syntax) {
        return OF_NUMBERS.stream().anyMatch(syntax.getOriginalMessage()::contains);
    }

    /** What is wrong with a number that is written like this. */
    static String ofNumber(String number) {
        return NOT_JSON + NUMBERS + ", found " + Problems.shortened(number);
    }

    static String message(JacksonException syntax, JsonParser parser) {
        String message = syntax.getOriginalMessage();
        if (isInComment(syntax)) {
            return "the text ends too early: a comment begins behind this place, and its */ is missing";
        }
        if (isEndOfText(syntax)) {
            return "the text ends too early" + unclosed(parser);
        }
        if (message.startsWith("Unexpected close marker")) {
            Matcher bracket = WRONG_BRACKET.matcher(message);
            return bracket.lookingAt()
                    ? NOT_JSON + "found " + bracket.group(1) + " where " + bracket.group(2) + " belongs"
                            + unclosed(parser)
                    : NOT_JSON + "there is a closing bracket or brace too many";
        }
        for (Map.Entry<Pattern, Function<String, String>> each : WITH_FOUND) {
            Matcher matcher = each.getKey().matcher(message);
            if (matcher.lookingAt()) {
                return NOT_JSON + each.getValue().apply(matcher.group(1));
            }
        }
        Matcher wrong = WRONG_CHARACTER.matcher(message);
        String character = wrong.lookingAt() ? Problems.shortened(wrong.group(1)) : "";
        String found = character.isBlank() ? "" : ", found " + character;
        for (Map.Entry<String, String> meaning : MEANINGS) {
            if (message.contains(meaning.getKey())) {
                return NOT_JSON + meaning.getValue() + found;
            }
        }
        return NOT_JSON + "what stands here does not belong here" + found;
    }

    private static String controlCharacter(String code) {
        return String.format(Locale.ROOT, "the control character U+%04X", Integer.parseInt(code));
    }

    private static String escapedControl(String code) {
        int letter = Integer.parseInt(code);
        return "a text must not contain a backslash before "
                + (letter == '\n' || letter == '\r' ? "the end of a line" : controlCharacter(code))
                + "; a backslash itself is written \\\\, and a new line \\n";
    }

    private static String controlInText(String code) {
        return switch (Integer.parseInt(code)) {
            case '\n', '\r' ->
                "a text must end on the line where it begins; a quote is missing"
                        + " (inside a text, \\n is a new line and \\t a tab)";
            case '\t' -> "inside a text, a tab is written \\t";
            default ->
                "a text must not contain " + controlCharacter(code)
                        + String.format(Locale.ROOT, " as it is; it is written \\u%04x", Integer.parseInt(code));
        };
    }

    private static String unclosed(JsonParser parser) {
        TokenStreamContext context = parser.streamReadContext();
        if (context == null || context.inRoot()) {
            return "";
        }
        String bracket = context.inArray() ? "[" : "{";
        int line = context.startLocation(ContentReference.unknown()).getLineNr();
        return "; the " + bracket + " of line " + line + " is not closed";
    }
}
