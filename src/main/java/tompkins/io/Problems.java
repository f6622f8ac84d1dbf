package tompkins.io;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.Member;
import tompkins.property.InvalidPropertyException;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;
import tompkins.property.OneLine;

/** Collects the mistakes of one file, or of options that stand for lines of it. */
final class Problems {

    /** After so many mistakes the rest of the file is not looked at. */
    static final int MOST = 100;

    private static final int LONGEST_VALUE = 60;
    private static final int LONGEST_PATH = 100;

    private final String file;
    private final List<String> options;
    private final List<Problem> found = new ArrayList<>();

    /** A mistake; line and column begin at 1, and are 0 if it concerns the whole file. */
    private record Problem(int line, int column, String text) {}

    /** The mistakes of a file. */
    Problems(String file) {
        this.file = file;
        options = List.of();
    }

    /** The mistakes of options by their names; each has its number, from 1, as the line of all that it holds. */
    Problems(List<String> options) {
        file = "";
        this.options = options;
    }

    /**
     * Does nothing if no mistake was noted.
     *
     * @throws MistakeException for all mistakes that were
     */
    void throwIfAny() {
        if (!found.isEmpty()) {
            throw exception();
        }
    }

    /** Notes a mistake in a value. */
    void add(JsonValue value, String path, String message) {
        add(value.line(), value.column(), path, message);
    }

    /**
     * Notes a mistake at a place: {@code file:line:column: path: message}, or the name of an option before its path.
     *
     * @param line from 1; 0 if the mistake concerns the whole file
     * @param column in characters, from 1
     * @param path the keys that lead to the place, such as {@code scene[2].radius}; empty for the whole scene
     * @param message what is wrong, the value, and what is allowed
     * @throws MistakeException if there are too many
     */
    void add(int line, int column, String path, String message) {
        String place = line == 0 ? file : options.isEmpty() ? file + ":" + line + ":" + column : options.get(line - 1);
        String part = path.isEmpty() ? "" : OneLine.shortened(path, LONGEST_PATH) + ": ";
        found.add(new Problem(line, column, place + ": " + part + message));
        if (found.size() == MOST) {
            found.add(new Problem(
                    Integer.MAX_VALUE, 0, place + ": after " + MOST + " mistakes the rest is not looked at"));
            throw exception();
        }
    }

    /**
     * Notes a value that a constructor refused, at the place of the property that it names.
     *
     * @param value the object with that property, or the property's value itself
     */
    void note(InvalidPropertyException invalid, JsonValue value, String path) {
        note(invalid, value, path, "");
    }

    /** As above, with a hint at the end. */
    void note(InvalidPropertyException invalid, JsonValue value, String path, String hint) {
        String property = invalid.property();
        Member member = value instanceof JsonObject object ? object.members().get(component(invalid)) : null;
        if (member != null) {
            String problem = member.value() instanceof JsonNumber number ? problem(invalid, number) : invalid.problem();
            add(member.value(), path.isEmpty() ? property : path + "." + property, problem + hint);
        } else {
            add(value, path, (value instanceof JsonObject ? invalid.getMessage() : invalid.problem()) + hint);
        }
    }

    /** The problem with a number. One that is too large to be kept is shown as it is written. */
    private static String problem(InvalidPropertyException invalid, JsonNumber number) {
        double size = Math.abs(Double.parseDouble(number.text()));
        String problem = size > Integer.MAX_VALUE ? invalid.problem(number.shown()) : invalid.problem();
        return Double.isInfinite(size) && problem.contains("finite")
                ? problem + " (no number can be larger than " + NumberText.of(Double.MAX_VALUE) + ")"
                : problem;
    }

    /** The name of the component; a property may add in brackets which part of it is wrong. */
    static String component(InvalidPropertyException invalid) {
        return invalid.property().split(" ", 2)[0];
    }

    /** Notes the unknown keys of an object, and says whether there are none. */
    boolean noteUnknownKeys(JsonObject object, String path, List<String> known) {
        return noteUnknownKeys(object, path, known, key -> "");
    }

    /** As above, with another hint for keys that are similar to none. */
    boolean noteUnknownKeys(JsonObject object, String path, List<String> known, UnaryOperator<String> home) {
        boolean clear = true;
        for (Map.Entry<String, Member> entry : object.members().entrySet()) {
            if (!known.contains(entry.getKey())) {
                clear = false;
                String similar = Spelling.hint(entry.getKey(), known);
                String hint = similar.isEmpty() ? home.apply(entry.getKey()) : similar;
                String allowed = known.isEmpty() ? "there are none here" : "allowed are " + String.join(", ", known);
                add(
                        entry.getValue().line(),
                        entry.getValue().column(),
                        path,
                        "unknown key " + quoted(entry.getKey()) + "; " + allowed + hint);
            }
        }
        return clear;
    }

    /** The exception for a mistake of the whole file. */
    MistakeException wholeFile(String message) {
        add(0, 0, "", message);
        return exception();
    }

    /** The exception for all mistakes that were found, in the order of the file. */
    MistakeException exception() {
        return new MistakeException(found.stream()
                .sorted(Comparator.comparingInt(Problem::line).thenComparingInt(Problem::column))
                .map(Problem::text)
                .toList());
    }

    /** A text of the user, for a message: in quotes and shortened if it is long. */
    static String quoted(String text) {
        return '"' + shortened(text) + '"';
    }

    /** A text on one line, shortened if it is long. */
    static String shortened(String text) {
        return OneLine.shortened(text, LONGEST_VALUE);
    }
}
