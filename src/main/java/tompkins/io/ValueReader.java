package tompkins.io;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import org.joml.Vector2i;
import org.joml.Vector2ic;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector3i;
import org.joml.Vector3ic;
import tompkins.io.JsonValue.JsonFlag;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.property.NumberText;
import tompkins.ray.Colour;
import tompkins.studio.StudioPath;

/** Makes plain values from JSON: numbers, texts, vectors, colours. A method notes a mistake and returns null. */
final class ValueReader {

    /** More digits take long to read, and no whole number needs them. */
    private static final int MOST_DIGITS = 100;

    private final Problems problems;

    ValueReader(Problems problems) {
        this.problems = problems;
    }

    /** A number; infinite if it is too large, so that the description that gets it can say what range is allowed. */
    Double unlimited(JsonValue value, String path) {
        if (!(value instanceof JsonNumber number)) {
            return refuse(value, path, "a number");
        }
        if (Character.isLetter(number.text().charAt(number.text().length() - 1))) {
            return refuse(value, path, "a finite number");
        }
        double parsed = Double.parseDouble(number.text());
        return parsed == 0 && NumberText.vanishes(number.text())
                ? refuse(value, path, NumberText.NOT_VANISHING)
                : (Double) parsed;
    }

    /** A number that is not too large. */
    Double number(JsonValue value, String path) {
        Double result = unlimited(value, path);
        return result == null || Double.isFinite(result) ? result : limited(double.class, result, value, path);
    }

    /** A whole number; the nearest that there is if it is too large, as in {@link #unlimited}. */
    Integer unlimitedWhole(JsonValue value, String path) {
        Double result = value instanceof JsonNumber ? unlimited(value, path) : refuse(value, path, "a whole number");
        if (result != null && result != Math.rint(result)) {
            return refuse(value, path, "a whole number");
        }
        return result == null ? null : (Integer) result.intValue();
    }

    /** A whole number that is not too large. */
    Integer wholeNumber(JsonValue value, String path) {
        Integer result = unlimitedWhole(value, path);
        return result == null ? null : limited(int.class, result, value, path);
    }

    /** Passes on a result that was read from a number of some type, unless that was too large for it. */
    <T> T limited(Class<?> type, T result, JsonValue value, String path) {
        if (value instanceof JsonNumber number) {
            double written = type == int.class || type == double.class ? Double.parseDouble(number.text()) : 0;
            if (Double.isInfinite(written)) {
                return refuse(value, path, "a number that is not larger than " + NumberText.of(Double.MAX_VALUE));
            }
            if (type == int.class && written != (int) written) {
                return refuse(value, path, "a whole number from " + Integer.MIN_VALUE + " to " + Integer.MAX_VALUE);
            }
        }
        return result;
    }

    Long longNumber(JsonValue value, String path) {
        if (!(value instanceof JsonNumber number) || number.text().length() > MOST_DIGITS) {
            return refuse(value, path, "a whole number");
        }
        try {
            return new BigDecimal(number.text()).longValueExact();
        } catch (ArithmeticException | NumberFormatException notWhole) {
            return refuse(value, path, "a whole number from -2^63 to 2^63 - 1");
        }
    }

    Boolean flag(JsonValue value, String path) {
        return value instanceof JsonFlag flag ? (Boolean) flag.value() : refuse(value, path, "true or false");
    }

    String text(JsonValue value, String path) {
        return value instanceof JsonText text ? text.text() : refuse(value, path, "a text in quotes");
    }

    Object constant(Class<?> type, JsonValue value, String path) {
        List<String> names = DescriptionTypes.constantNames(type);
        String allowed = "one of " + String.join(", ", names);
        if (!(value instanceof JsonText text)) {
            return refuse(value, path, allowed);
        }
        String wanted = text.text().toLowerCase(Locale.ROOT).replaceAll("[_ ]", "-");
        int index = names.indexOf(wanted);
        if (index >= 0) {
            return type.getEnumConstants()[index];
        }
        return refuse(value, path, allowed, Spelling.hint(text.text(), names));
    }

    Vector3dc vector(JsonValue value, String path) {
        List<Double> numbers = numbers(value, path, 3, "three numbers [x, y, z]", this::number);
        return numbers == null ? null : new Vector3d(numbers.get(0), numbers.get(1), numbers.get(2));
    }

    /** A vector with other numbers for some of its components. */
    Vector3dc changedVector(JsonObject parts, String path, Vector3dc present) {
        List<String> axes = StudioPath.stepsFrom(present);
        boolean clear = problems.noteUnknownKeys(parts, path, axes);
        Vector3d changed = new Vector3d(present);
        for (String axis : axes) {
            Member component = parts.members().get(axis);
            Double number = component == null ? null : number(component.value(), path + "." + axis);
            if (number != null) {
                changed.setComponent(axes.indexOf(axis), number);
            }
            clear &= component == null || number != null;
        }
        return clear ? changed : null;
    }

    Vector3ic wholeVector(JsonValue value, String path) {
        List<Integer> numbers = numbers(value, path, 3, "three whole numbers [x, y, z]", this::wholeNumber);
        return numbers == null ? null : new Vector3i(numbers.get(0), numbers.get(1), numbers.get(2));
    }

    Vector2ic wholePair(JsonValue value, String path) {
        List<Integer> numbers = numbers(value, path, 2, "two whole numbers [x, y]", this::wholeNumber);
        return numbers == null ? null : new Vector2i(numbers.get(0), numbers.get(1));
    }

    Colour colour(JsonValue value, String path) {
        if (value instanceof JsonNumber) {
            Double grey = number(value, path);
            return grey == null ? null : Colour.grey(grey);
        }
        String allowed = "three numbers [red, green, blue], or one number for a grey";
        List<Double> numbers = numbers(value, path, 3, allowed, this::number);
        return numbers == null ? null : new Colour(numbers.get(0), numbers.get(1), numbers.get(2));
    }

    private <T> List<T> numbers(
            JsonValue value, String path, int count, String allowed, BiFunction<JsonValue, String, T> reader) {
        if (!(value instanceof JsonList list) || list.values().size() != count) {
            return refuse(value, path, allowed);
        }
        List<T> numbers = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            numbers.add(reader.apply(list.values().get(i), path + "[" + i + "]"));
        }
        return numbers.contains(null) ? null : numbers;
    }

    /** Notes that a value must be something else; returns null. */
    <T> T refuse(JsonValue value, String path, String allowed) {
        return refuse(value, path, allowed, "");
    }

    private <T> T refuse(JsonValue value, String path, String allowed, String hint) {
        problems.add(value, path, "must be " + allowed + ", was " + value.shown() + hint);
        return null;
    }
}
