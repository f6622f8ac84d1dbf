package tompkins.io;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tompkins.io.JsonValue.JsonFlag;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNull;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.property.MistakeException;
import tompkins.property.OneLine;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamContext;
import tools.jackson.core.TokenStreamFactory;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.io.ContentReference;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;

/** Makes a tree of values from the text of a scene file: JSON with comments and trailing commas. */
final class JsonParsing {

    /** Values inside values inside values... */
    static final int DEEPEST = 200;

    private static final int LONGEST_KEY = 200;

    /** Bounds the memory that a file can take. */
    static final int MOST_VALUES = 2_000_000;

    private static final JsonFactory FACTORY = JsonFactory.builder()
            .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
            .enable(JsonReadFeature.ALLOW_TRAILING_COMMA)
            // accepted here, so that the message can say where they are and what is allowed
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .disable(TokenStreamFactory.Feature.CANONICALIZE_PROPERTY_NAMES)
            // the length of the file bounds all of these
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(DEEPEST + 10)
                    .maxStringLength(Integer.MAX_VALUE)
                    .maxNameLength(Integer.MAX_VALUE)
                    .maxNumberLength(Integer.MAX_VALUE)
                    .build())
            .build();

    private static final int LONGEST_MESSAGE = 200;

    /** What the library says in other words: regular expressions, and what stands in their places. */
    private static final List<Map.Entry<String, String>> PLAINER = List.of(
            Map.entry(
                    "(?s)^Illegal unquoted character \\(\\(CTRL-CHAR, code 1[03]\\).*",
                    "a text must end on the line where it begins; a quote is missing"),
            Map.entry("(?s)^(Unrecognized character escape .*)", "$1; a backslash itself is written \\\\\\\\"),
            Map.entry(
                    "(was expecting|expected a valid value) \\(JSON String.*",
                    "expected a text in quotes, a number, true, false, a list [ ] or an object { }"),
            Map.entry(": (enable|hexadecimal) .*| \\([^()]*\\[Source: .*| \\(code \\d+\\)", ""),
            Map.entry("\\(\\(CTRL-CHAR, (code \\d+)\\)\\)", "($1)"),
            Map.entry(
                    "(?s)^(.* numeric value.*|Unexpected character \\('[.+xX]'\\).*)",
                    "$1; a number is written like 0.5, -2 or 1e-9"));

    private static final String NEEDED =
            "a scene file (JSON, an object in braces { ... }) or a photograph saved by this program is needed";

    private final JsonParser parser;
    private final String text;
    private final Problems problems;
    private int values;

    /** The line in which all values are, or 0 for that of the text. */
    private final int onlyLine;

    private JsonParsing(JsonParser parser, String text, Problems problems, int onlyLine) {
        this.parser = parser;
        this.text = text;
        this.problems = problems;
        this.onlyLine = onlyLine;
    }

    /**
     * The object that a text holds. Keys that occur twice are noted; the first one counts.
     *
     * @throws MistakeException if the text is not JSON, or not an object
     */
    static JsonObject parse(String text, Problems problems) {
        try (JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), text)) {
            return new JsonParsing(parser, text, problems, 0).root();
        }
    }

    /**
     * The value that a text holds, which stands for itself and not in a file.
     *
     * @param line what messages are to give as the line of all that is in it
     * @throws MistakeException if the text is not JSON
     */
    static JsonValue parseValue(String text, String path, Problems problems, int line) {
        try (JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), text)) {
            JsonParsing parsing = new JsonParsing(parser, text, problems, line);
            parsing.next(path);
            JsonValue value = parsing.value(path, 0);
            if (parsing.next(path) != null) {
                throw parsing.failure(line, 1, path, "the value ends before its last letters");
            }
            return value;
        }
    }

    private JsonObject root() {
        if (first() == null) {
            throw problems.wholeFile("the file is empty; the smallest scene file is {}");
        }
        JsonValue value = value("", 0);
        if (!(value instanceof JsonObject root)) {
            throw failure(value.line(), value.column(), "", NEEDED + ", found " + value.shown());
        }
        if (next("") != null) {
            throw failure(line(), column(), "", "the scene ends before this place");
        }
        return root;
    }

    /** The first token; a text without one is not a damaged scene file but something else. */
    private JsonToken first() {
        try {
            return parser.nextToken();
        } catch (JacksonException syntax) {
            int number = syntax.getLocation().getLineNr();
            String line = text.lines().skip(number - 1L).findFirst().orElse("");
            int blanks = line.length() - line.stripLeading().length();
            throw failure(number, blanks + 1, "", NEEDED + ", found " + Problems.quoted(line.strip()));
        }
    }

    private JsonToken next(String path) {
        try {
            return parser.nextToken();
        } catch (JacksonException syntax) {
            throw failure(path, syntax);
        }
    }

    private JsonValue value(String path, int depth) {
        int line = line();
        int column = column();
        if (++values > MOST_VALUES) {
            throw failure(line, column, path, "a scene file may hold at most " + MOST_VALUES + " values");
        }
        return switch (parser.currentToken()) {
            case START_OBJECT -> object(path, depth, line, column);
            case START_ARRAY -> list(path, depth, line, column);
            case VALUE_STRING -> {
                String written = string(path);
                requireWholeCharacters(written, line, column, path);
                yield new JsonText(line, column, written);
            }
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new JsonNumber(line, column, string(path));
            case VALUE_TRUE -> new JsonFlag(line, column, true);
            case VALUE_FALSE -> new JsonFlag(line, column, false);
            default -> new JsonNull(line, column);
        };
    }

    /** The text of the token, which is read to its end only now. */
    private String string(String path) {
        try {
            return parser.getString();
        } catch (JacksonException syntax) {
            throw failure(path, syntax);
        }
    }

    private JsonObject object(String path, int depth, int line, int column) {
        requireDepth(path, depth, line, column);
        Map<String, Member> members = new LinkedHashMap<>();
        while (next(path) == JsonToken.PROPERTY_NAME) {
            String key = parser.currentName();
            int keyLine = line();
            int keyColumn = column();
            if (key.length() > LONGEST_KEY) {
                throw failure(
                        keyLine,
                        keyColumn,
                        path,
                        "unknown key " + Problems.quoted(key) + "; no key has more than " + LONGEST_KEY);
            }
            requireWholeCharacters(key, keyLine, keyColumn, path);
            String inner = path.isEmpty() ? key : path + "." + key;
            next(inner);
            Member first = members.putIfAbsent(key, new Member(keyLine, keyColumn, value(inner, depth + 1)));
            if (first != null) {
                String message = "the key occurs twice; the first time is in line " + first.line();
                problems.add(keyLine, keyColumn, inner, message);
            }
        }
        return new JsonObject(line, column, members);
    }

    private JsonList list(String path, int depth, int line, int column) {
        requireDepth(path, depth, line, column);
        List<JsonValue> elements = new ArrayList<>();
        while (next(path) != JsonToken.END_ARRAY) {
            elements.add(value(path + "[" + elements.size() + "]", depth + 1));
        }
        return new JsonList(line, column, elements);
    }

    /** Half of a pair that stands for one character could not be saved again. */
    private void requireWholeCharacters(String written, int line, int column, String path) {
        for (int i = 0; i < written.length(); i += Character.charCount(written.codePointAt(i))) {
            int letter = written.codePointAt(i);
            if (letter >= Character.MIN_SURROGATE && letter <= Character.MAX_SURROGATE) {
                String message = String.format(
                        Locale.ROOT,
                        "a text must not contain \\u%04x alone: it is half of a character, and the other half is missing",
                        letter);
                throw failure(line, column, path, message);
            }
        }
    }

    private void requireDepth(String path, int depth, int line, int column) {
        if (depth >= DEEPEST) {
            throw failure(line, column, path, "brackets and braces may be at most " + DEEPEST + " deep");
        }
    }

    private MistakeException failure(String path, JacksonException syntax) {
        TokenStreamLocation place = syntax.getLocation();
        String message = syntax.getOriginalMessage();
        for (Map.Entry<String, String> plainer : PLAINER) {
            message = message.replaceAll(plainer.getKey(), plainer.getValue());
        }
        return failure(
                place == null ? line() : place.getLineNr(),
                place == null ? column() : place.getColumnNr(),
                path,
                "not valid JSON: " + OneLine.shortened(message, LONGEST_MESSAGE) + unclosed(message));
    }

    /** Where the brace or bracket begins whose end is missing. */
    private String unclosed(String message) {
        TokenStreamContext context = parser.streamReadContext();
        if (context == null || context.inRoot() || !message.matches("Unexpected (end-of-input|close marker).*")) {
            return "";
        }
        int line = context.startLocation(ContentReference.unknown()).getLineNr();
        return "; the " + (context.inArray() ? "[" : "{") + " of line " + line + " is not closed";
    }

    private MistakeException failure(int line, int column, String path, String message) {
        problems.add(onlyLine > 0 ? onlyLine : line, column, path, message);
        return problems.exception();
    }

    private int line() {
        return onlyLine > 0 ? onlyLine : parser.currentTokenLocation().getLineNr();
    }

    private int column() {
        return parser.currentTokenLocation().getColumnNr();
    }
}
