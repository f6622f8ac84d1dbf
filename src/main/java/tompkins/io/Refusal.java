package tompkins.io;

import java.util.List;
import java.util.Map;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.Member;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;

/** Notes what is wrong with the keys of an object, and what the constructors of descriptions refuse. */
final class Refusal {

    private Refusal() {}

    /**
     * Notes a value that a constructor refused, at the place of the property that it names.
     *
     * @param value the object with that property, or the property's value itself
     */
    static void note(Problems problems, InvalidPropertyException invalid, JsonValue value, String path) {
        note(problems, invalid, value, path, "");
    }

    /** As above, with a hint at the end. */
    static void note(Problems problems, InvalidPropertyException invalid, JsonValue value, String path, String hint) {
        String property = invalid.property();
        Member member = value instanceof JsonObject object ? object.members().get(component(invalid)) : null;
        if (member != null) {
            String problem = member.value() instanceof JsonNumber number ? problem(invalid, number) : invalid.problem();
            problems.add(member.value(), path.isEmpty() ? property : path + "." + property, problem + hint);
        } else {
            problems.add(value, path, (value instanceof JsonObject ? invalid.getMessage() : invalid.problem()) + hint);
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
    static boolean noteUnknownKeys(Problems problems, JsonObject object, String path, List<String> known) {
        boolean clear = true;
        for (Map.Entry<String, Member> entry : object.members().entrySet()) {
            if (!known.contains(entry.getKey())) {
                clear = false;
                String allowed = known.isEmpty() ? "there are none here" : "allowed are " + String.join(", ", known);
                problems.add(
                        entry.getValue().line(),
                        entry.getValue().column(),
                        path,
                        "unknown key " + Problems.quoted(entry.getKey()) + "; " + allowed
                                + Spelling.hint(entry.getKey(), known));
            }
        }
        return clear;
    }
}
