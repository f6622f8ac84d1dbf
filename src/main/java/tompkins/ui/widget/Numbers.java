package tompkins.ui.widget;

import java.math.BigDecimal;
import java.util.function.DoubleFunction;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.spacetime.Event;

/** Numbers as texts and back; always with a decimal point. */
public final class Numbers {

    /** A coordinate that is smaller than this part of the largest one is what rounding has left. */
    private static final double ROUNDING = 1e-12;

    private Numbers() {}

    /**
     * The number that a text writes.
     *
     * @throws InvalidPropertyException if it is not a number
     */
    static double parse(String property, String text) {
        try {
            String plain = text.strip().replace('\u2212', '-');
            double number = NumberText.parse(plain);
            if (NumberText.vanishes(plain)) {
                throw new InvalidPropertyException(property, NumberText.NOT_VANISHING, plain);
            }
            return number;
        } catch (NumberFormatException e) {
            throw noNumber(property, "a number such as 0.5 or 2e-3", text);
        }
    }

    /**
     * The whole number that a text writes, such as 640 or 1e6.
     *
     * @throws InvalidPropertyException if it is not a whole number from the minimum to the maximum, both included
     */
    static long parseWhole(String property, String text, long minimum, long maximum) {
        String allowed = "a whole number";
        BigDecimal number;
        try {
            number = new BigDecimal(NumberText.withPoint(text.strip().replace('\u2212', '-')));
        } catch (NumberFormatException e) {
            throw new InvalidPropertyException(property, allowed, quoted(text));
        }
        if (number.stripTrailingZeros().scale() > 0) {
            throw new InvalidPropertyException(property, allowed, text.strip());
        }
        if (number.compareTo(BigDecimal.valueOf(minimum)) < 0 || number.compareTo(BigDecimal.valueOf(maximum)) > 0) {
            throw new InvalidPropertyException(property, allowed + " from " + minimum + " to " + maximum, text.strip());
        }
        return number.longValueExact();
    }

    /** What to say about a text that is not a number; many languages write a comma where programs want a point. */
    static InvalidPropertyException noNumber(String property, String allowed, String text) {
        boolean comma = text.matches(".*\\d\\s*,\\s*\\d.*");
        return new InvalidPropertyException(
                property, comma ? allowed + ", with a point, not a comma" : allowed, quoted(text));
    }

    private static String quoted(String text) {
        return text.isBlank() ? "empty" : "\"" + text.strip() + "\"";
    }

    /** As many digits of a number as it needs, and no more. */
    public static String text(double value) {
        // nobody types a negative zero
        return NumberText.of(value + 0.0);
    }

    /** As many digits of a number as fit into some characters. */
    public static String fitting(double value, int characters) {
        String text = text(value);
        for (int digits = characters; digits > 1 && text.length() > characters; digits--) {
            text = text(NumberText.rounded(value, digits));
        }
        return text;
    }

    /** The first four digits of a number, for reading. */
    public static String brief(double value) {
        return brief(value, 4);
    }

    /** The first {@code digits} digits of a number, for reading. */
    public static String brief(double value, int digits) {
        if (!Double.isFinite(value)) {
            return value > 0 ? "\u221e" : value < 0 ? "-\u221e" : Texts.get("number.none");
        }
        return text(NumberText.rounded(value, digits));
    }

    /** The first digits of three numbers. */
    public static String brief(Vector3dc vector) {
        return "(" + brief(vector.x()) + ", " + brief(vector.y()) + ", " + brief(vector.z()) + ")";
    }

    /** The first digits of place and time, without rounding errors; no line breaks inside the equation of the time. */
    public static String brief(Event event) {
        double largest = Math.max(event.position().length(), Math.abs(event.time()));
        DoubleFunction<String> text = value -> brief(Math.abs(value) < ROUNDING * largest ? 0 : value);
        return "(" + text.apply(event.x()) + ", " + text.apply(event.y()) + ", " + text.apply(event.z())
                + "; t\u00a0=\u00a0" + text.apply(event.time()) + ")";
    }

    /** The smallest of ..., 1, 2, 5, 10, 20, ... that is not below a positive number. */
    public static double niceCeiling(double value) {
        double power = Math.pow(10, Math.floor(Math.log10(value)));
        for (double step : new double[] {1, 2, 5}) {
            if (step * power >= value) {
                return NumberText.rounded(step * power, 1);
            }
        }
        return NumberText.rounded(10 * power, 1);
    }

    /** The largest of ..., 1, 2, 5, 10, 20, ... that is not above a positive number; 0 for 0. */
    public static double niceFloor(double value) {
        double power = Math.pow(10, Math.floor(Math.log10(value)));
        double first = value / power;
        return value == 0 ? 0 : NumberText.rounded(power * (first >= 5 ? 5 : first >= 2 ? 2 : 1), 1);
    }

    /** A vector whose components have so many digits. */
    public static Vector3d rounded(Vector3dc vector, int digits) {
        return new Vector3d(
                NumberText.rounded(vector.x(), digits),
                NumberText.rounded(vector.y(), digits),
                NumberText.rounded(vector.z(), digits));
    }
}
