package tompkins.ui.widget;

import tompkins.property.NumberText;

/**
 * The values that a slider gives: from 0 at its left end to 1 at its right end.
 *
 * @param minimum the value at the left end
 * @param maximum the value at the right end
 * @param power 1 for even steps; above 1 for steps that are finer near the minimum
 * @param bend the value at {@link #BEND} of the length, where even steps become larger; NaN if they do not
 */
public record Range(double minimum, double maximum, double power, double bend) {

    /** Where steps become larger, as a share of the length. */
    private static final double BEND = 0.8;

    /** Values without a bend. */
    public Range(double minimum, double maximum, double power) {
        this(minimum, maximum, power, Double.NaN);
    }

    /** Values in even steps up to one that is reached at four fifths of the length, and in larger ones from there. */
    public static Range bent(double minimum, double bend, double maximum) {
        return new Range(minimum, maximum, 1, bend);
    }

    /** Values in even steps. */
    public static Range even(double minimum, double maximum) {
        return new Range(minimum, maximum, 1);
    }

    /** The value at a place of the slider, with no more digits than a hand can choose; exact at both ends. */
    double value(double place) {
        if (place <= 0) {
            return minimum;
        }
        if (place >= 1) {
            return maximum;
        }
        double value = Double.isNaN(bend)
                ? minimum + (maximum - minimum) * Math.pow(place, power)
                : place < BEND
                        ? minimum + (bend - minimum) * place / BEND
                        : bend + (maximum - bend) * (place - BEND) / (1 - BEND);
        double step = Math.pow(10, Math.floor(Math.log10(maximum - minimum)) - (power == 1 ? 3 : 4));
        return NumberText.rounded(Math.rint(value / step) * step, 12);
    }

    /** The place of a value, inside the slider even if the value is not. */
    double place(double value) {
        if (!Double.isNaN(bend)) {
            double share = value < bend
                    ? BEND * (value - minimum) / (bend - minimum)
                    : BEND + (1 - BEND) * (value - bend) / (maximum - bend);
            return Math.max(0, Math.min(1, share));
        }
        double share = (value - minimum) / (maximum - minimum);
        return Math.pow(Math.max(0, Math.min(1, share)), 1 / power);
    }
}
