package tompkins.ui.widget;

import java.util.function.DoubleUnaryOperator;
import tompkins.property.NumberText;

/**
 * The values that a slider gives: from its left end, the position 0, to its right end, the position 1.
 *
 * @param minimum the value at the left end
 * @param maximum the value at the right end
 * @param values the value at a position
 * @param positions the position of a value
 */
public record Range(double minimum, double maximum, DoubleUnaryOperator values, DoubleUnaryOperator positions) {

    /** Values in steps that are finer near the minimum: power 1 gives even steps. */
    public Range(double minimum, double maximum, double power) {
        this(
                minimum,
                maximum,
                position ->
                        rounded(minimum + (maximum - minimum) * Math.pow(position, power), maximum - minimum, power),
                value -> Math.pow(Math.max(0, (value - minimum) / (maximum - minimum)), 1 / power));
    }

    /** Values in even steps. */
    public static Range even(double minimum, double maximum) {
        return new Range(minimum, maximum, 1);
    }

    /**
     * Speeds in units of c, from rest on, in even steps of rapidity: 1 - beta has the few digits that a hand can
     * choose.
     */
    public static Range speeds(double fastest) {
        return new Range(
                0,
                fastest,
                position -> {
                    double rest = 1 - Math.tanh(position * artanh(fastest));
                    return NumberText.rounded(1 - NumberText.rounded(rest, rest > 0.1 ? 3 : 2), 12);
                },
                speed -> speed < 1 ? artanh(speed) / artanh(fastest) : 1);
    }

    private static double artanh(double speed) {
        return (Math.log1p(speed) - Math.log1p(-speed)) / 2;
    }

    /** A value with no more digits than a hand can choose. */
    private static double rounded(double value, double length, double power) {
        double step = Math.pow(10, Math.floor(Math.log10(length)) - (power == 1 ? 3 : 4));
        return NumberText.rounded(Math.rint(value / step) * step, 12);
    }

    /** The value at a position of the slider; exact at both ends. */
    double value(double position) {
        return position <= 0 ? minimum : position >= 1 ? maximum : values.applyAsDouble(position);
    }

    /** The position of a value, inside the slider even if the value is not. */
    double position(double value) {
        return Math.max(0, Math.min(1, positions.applyAsDouble(value)));
    }
}
