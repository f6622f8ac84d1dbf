package tompkins.bench;

import java.util.Arrays;
import java.util.Locale;

/**
 * One line of the table: what was measured, what it should be, and what it is.
 *
 * @param met whether the target is met, or null where nothing could be measured
 */
record Measure(String what, String target, String measured, Boolean met) {

    /** A number that should be at most {@code most}. */
    static Measure atMost(String what, double most, String unit, double measured) {
        return new Measure(
                what, "at most " + number(most) + " " + unit, number(measured) + " " + unit, measured <= most);
    }

    /** A number that should be at least {@code least}. */
    static Measure atLeast(String what, double least, String unit, double measured) {
        return new Measure(
                what, "at least " + number(least) + " " + unit, number(measured) + " " + unit, measured >= least);
    }

    /** Something that could not be measured here, and why. */
    static Measure missing(String what, String why) {
        return new Measure(what, "", why, null);
    }

    /** The median of some numbers; of an even number of them the upper one of the two in the middle. */
    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /** A number with three digits that count. */
    static String number(double value) {
        double size = Math.abs(value);
        int decimals = size >= 100 || value == Math.rint(value) ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
        return String.format(Locale.ROOT, "%." + decimals + "f", value);
    }

    /** The line as Markdown. */
    String line() {
        String verdict = met == null ? "not measured" : met ? "yes" : "**no**";
        return "| " + what + " | " + target + " | " + measured + " | " + verdict + " |\n";
    }
}
