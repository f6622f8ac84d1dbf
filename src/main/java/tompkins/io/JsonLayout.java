package tompkins.io;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import tompkins.property.NumberText;
import tools.jackson.core.io.JsonStringEncoder;

/**
 * Lays out JSON for people: what fits on one line is on one line, the rest has a line for each key. The same values
 * give the same text on every system.
 */
public final class JsonLayout {

    private static final int WIDTH = 100;
    private static final int INDENT = 2;

    private JsonLayout() {}

    /**
     * The text of a value.
     *
     * @param value a map with texts as keys, a list, a text, a number, a truth value or null
     */
    static String text(Object value) {
        return text(value, 0);
    }

    /** The text of a value, as {@link #text(Object)}, in one line. */
    public static String line(Object value) {
        // inside texts, ends of lines are escaped
        return text(value).replaceAll("(?<=[\\[{])\n *|\n *(?=[\\]}])", "").replaceAll("\n *", " ");
    }

    private static String text(Object value, int indent) {
        List<String> parts = new ArrayList<>();
        if (value instanceof Map<?, ?> map) {
            for (Map.Entry<?, ?> member : map.entrySet()) {
                parts.add(quoted((String) member.getKey()) + ": " + text(member.getValue(), indent + INDENT));
            }
            return bracketed("{", parts, "}", indent);
        }
        if (value instanceof List<?> list) {
            for (Object element : list) {
                // most are numbers: Java's compiler takes its time for a method that calls itself often
                parts.add(element instanceof Double number ? NumberText.of(number) : text(element, indent + INDENT));
            }
            return bracketed("[", parts, "]", indent);
        }
        if (value instanceof Double number) {
            return NumberText.of(number);
        }
        return value instanceof String text ? quoted(text) : String.valueOf(value);
    }

    private static String bracketed(String open, List<String> parts, String close, int indent) {
        int length = 0;
        for (String part : parts) {
            // what has lines of its own fits into none
            length += part.indexOf('\n') < 0 ? part.length() + 2 : WIDTH + 1;
        }
        if (length <= WIDTH - indent) {
            return open + String.join(", ", parts) + close;
        }
        String margin = "\n" + " ".repeat(indent);
        String inner = margin + " ".repeat(INDENT);
        return open + inner + String.join("," + inner, parts) + margin + close;
    }

    private static String quoted(String text) {
        return '"' + String.valueOf(JsonStringEncoder.getInstance().quoteAsCharArray(text)) + '"';
    }
}
