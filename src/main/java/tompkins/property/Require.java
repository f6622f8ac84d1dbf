package tompkins.property;

import java.util.List;
import java.util.Objects;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Checks of values in the constructors of descriptions. Each method returns a value that it accepts and throws
 * {@link InvalidPropertyException} for any other; NaN and infinity are never accepted.
 */
public final class Require {

    /** Places and times below this stay far below the root of the largest double, seen from any frame. */
    private static final double LARGEST_COORDINATE = 1e50;

    private Require() {}

    /** Any finite number. */
    public static double finite(String property, double value) {
        return check(Double.isFinite(value), property, "a finite number", value);
    }

    /** A finite number above 0. */
    public static double positive(String property, double value) {
        return check(value > 0 && Double.isFinite(value), property, "a finite number above 0", value);
    }

    /** A number above 0 and at most {@code maximum}. */
    public static double positive(String property, double value, double maximum) {
        return check(value > 0 && value <= maximum, property, "above 0 and at most " + NumberText.of(maximum), value);
    }

    /** A finite number, 0 or above. */
    public static double notNegative(String property, double value) {
        return check(value >= 0 && Double.isFinite(value), property, "a finite number, 0 or above", value);
    }

    /** A number, 0 or above, and below {@code limit}. */
    public static double notNegativeBelow(String property, double value, double limit) {
        return check(value >= 0 && value < limit, property, "0 or above, and below " + NumberText.of(limit), value);
    }

    /** 0, or a number from {@code minimum} to {@code maximum}, both included. */
    public static double zeroOrWithin(String property, double value, double minimum, double maximum) {
        return check(
                value == 0 || value >= minimum && value <= maximum,
                property,
                "0, or from " + NumberText.of(minimum) + " to " + NumberText.of(maximum),
                value);
    }

    /** A number from {@code minimum} to {@code maximum}, both included. */
    public static double within(String property, double value, double minimum, double maximum) {
        return check(
                value >= minimum && value <= maximum,
                property,
                "from " + NumberText.of(minimum) + " to " + NumberText.of(maximum),
                value);
    }

    /** A number between {@code minimum} and {@code maximum}, both excluded. */
    public static double between(String property, double value, double minimum, double maximum) {
        return check(
                value > minimum && value < maximum,
                property,
                "above " + NumberText.of(minimum) + " and below " + NumberText.of(maximum),
                value);
    }

    /** A number whose size, without its sign, lies from {@code minimum} to {@code maximum}, both included. */
    public static double sizeWithin(String property, double value, double minimum, double maximum) {
        double size = Math.abs(value);
        String positive = NumberText.of(minimum) + " to " + NumberText.of(maximum);
        return check(
                size >= minimum && size <= maximum,
                property,
                "from " + positive + ", or from " + NumberText.of(-maximum) + " to " + NumberText.of(-minimum),
                value);
    }

    /** A whole number from {@code minimum} to {@code maximum}, both included. */
    public static int within(String property, long value, int minimum, int maximum) {
        if (value < minimum || value > maximum) {
            throw wrong(property, "a whole number from " + minimum + " to " + maximum, value);
        }
        return (int) value;
    }

    /** A vector of three finite numbers; returns a copy that nobody else can change. */
    public static Vector3dc finite(String property, Vector3dc value) {
        if (value == null || !value.isFinite()) {
            throw wrong(property, "three finite numbers", text(value));
        }
        return new Vector3d(value);
    }

    /** A place along an axis, or a time: a number from -1e50 to 1e50. */
    public static double coordinate(String property, double value) {
        return within(property, value, -LARGEST_COORDINATE, LARGEST_COORDINATE);
    }

    /** A span of such times: a number from 0 to 1e50. */
    public static double duration(String property, double value) {
        return within(property, value, 0, LARGEST_COORDINATE);
    }

    /** A distance that light covers in such a time: a number above 0 and at most 1e50. */
    public static double distance(String property, double value) {
        return positive(property, value, LARGEST_COORDINATE);
    }

    /** A place of three such numbers; returns a copy that nobody else can change. */
    public static Vector3dc position(String property, Vector3dc value) {
        return position(property, value, LARGEST_COORDINATE);
    }

    /** A place of three numbers of at most a size; returns a copy that nobody else can change. */
    public static Vector3dc position(String property, Vector3dc value, double largest) {
        Vector3dc copy = finite(property, value);
        if (largestComponent(copy) > largest) {
            throw wrong(
                    property,
                    "three numbers from " + NumberText.of(-largest) + " to " + NumberText.of(largest),
                    text(copy));
        }
        return copy;
    }

    /** A vector of three finite numbers that are not all 0; returns a copy that nobody else can change. */
    public static Vector3dc direction(String property, Vector3dc value) {
        Vector3dc copy = finite(property, value);
        if (largestComponent(copy) == 0) {
            throw wrong(property, "a direction, not the zero vector", text(copy));
        }
        return copy;
    }

    /** Something, not null. */
    public static <T> T present(String property, T value) {
        if (value == null) {
            throw wrong(property, "given", "missing");
        }
        return value;
    }

    /** A list without gaps; returns a copy that nobody else can change. */
    public static <T> List<T> list(String property, List<T> value) {
        present(property, value);
        if (value.stream().anyMatch(Objects::isNull)) {
            throw wrong(property, "a list without empty places", "null");
        }
        return List.copyOf(value);
    }

    /** The vector as a scene file writes it: {@code [x, y, z]} with all digits. */
    public static String text(Vector3dc vector) {
        return vector == null
                ? "missing"
                : "[" + NumberText.of(vector.x()) + ", " + NumberText.of(vector.y()) + ", " + NumberText.of(vector.z())
                        + "]";
    }

    private static InvalidPropertyException wrong(String property, String allowed, Object value) {
        return new InvalidPropertyException(property, allowed, value, true);
    }

    private static double largestComponent(Vector3dc vector) {
        return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
    }

    private static double check(boolean allowed, String property, String what, double value) {
        if (!allowed) {
            throw wrong(property, what, value);
        }
        return value;
    }
}
