package tompkins.bench;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * One line of the page: what was measured, and what it is.
 *
 * @param value the number, or NaN if it could not be measured
 * @param unit its unit, or why it could not be measured
 * @param target what it should be, where somebody would notice a miss; else empty
 * @param met whether the target is met
 */
public record Measure(String what, double value, String unit, String target, boolean met) {

    /** A number that nobody notices if it is at most {@code most}. */
    static Measure noticedAtMost(String what, double most, String unit, double measured) {
        return new Measure(what, measured, unit, "at most " + number(most) + " " + unit, measured <= most);
    }

    /** A rate that is smooth if it is at least {@code least}. */
    static Measure noticedAtLeast(String what, double least, String unit, double measured) {
        return new Measure(what, measured, unit, "at least " + number(least) + " " + unit, measured >= least);
    }

    /** A number that has no target. */
    static Measure of(String what, String unit, double measured) {
        return new Measure(what, measured, unit, "", true);
    }

    /** Something that could not be measured here, and why. */
    static Measure missing(String what, String why) {
        return of(what, why, Double.NaN);
    }

    /** The median of some numbers; of an even number of them the upper one of the two in the middle. */
    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /** As above. */
    public static double median(List<? extends Number> values) {
        return median(values.stream().mapToDouble(Number::doubleValue).toArray());
    }

    /** A number with three digits that count. */
    static String number(double value) {
        double size = Math.abs(value);
        int decimals = size >= 100 || value == Math.rint(value) ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
        return String.format(Locale.ROOT, "%." + decimals + "f", value);
    }

    /** The number with its unit. */
    String measured() {
        return Double.isNaN(value) ? unit : (number(value) + " " + unit).strip();
    }

    /** The line as Markdown. */
    String line() {
        return "| " + what + " | " + measured() + " |"
                + (target.isEmpty() ? "" : " " + target.strip() + " | " + (met ? "yes" : "**no**") + " |") + "\n";
    }
}
