package tompkins.ui.widget;

import tompkins.property.NumberText;

/**
 * The values that a slider gives: from 0 at its left end to 1 at its right end.
 *
 * @param minimum the value at the left end
 * @param maximum the value at the right end
 * @param power 1 for even steps; above 1 for steps that are finer near the minimum
 */
public record Range(double minimum, double maximum, double power) {

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
        double value = minimum + (maximum - minimum) * Math.pow(place, power);
        double step = Math.pow(10, Math.floor(Math.log10(maximum - minimum)) - (power == 1 ? 3 : 4));
        return NumberText.rounded(Math.rint(value / step) * step, 12);
    }

    /** The place of a value, inside the slider even if the value is not. */
    double place(double value) {
        double share = (value - minimum) / (maximum - minimum);
        return Math.pow(Math.max(0, Math.min(1, share)), 1 / power);
    }
}
