package tompkins.io;

import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.TokenStreamContext;
import tools.jackson.core.exc.UnexpectedEndOfInputException;
import tools.jackson.core.io.ContentReference;

/** Says what is wrong with a text that is not JSON, in words that help to find it. */
final class SyntaxMistake {

    private SyntaxMistake() {}

    static String message(JacksonException syntax, JsonParser parser) {
        String message = syntax.getOriginalMessage();
        if (syntax instanceof UnexpectedEndOfInputException || message.startsWith("Unexpected end-of-input")) {
            return "the text ends too early" + unclosed(parser);
        }
        if (message.startsWith("Unexpected close marker")) {
            return "not valid JSON: " + message.replaceAll("\\s*\\(for .*", "") + unclosed(parser);
        }
        if (message.startsWith("Illegal unquoted character")) {
            return "not valid JSON: a text must end on the line where it begins; a quote is missing"
                    + " (inside a text, \\n is a new line and \\t a tab)";
        }
        if (message.startsWith("Unrecognized token")) {
            return "not valid JSON: " + message.replaceAll(": was expecting.*", "")
                    + "; allowed are texts in quotes, numbers, true, false, lists [ ] and objects { }";
        }
        return "not valid JSON: " + message;
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
