package tompkins.bench;

import java.util.Arrays;
import java.util.Locale;

/**
 * One line of the page: what was measured, what it should be, and what it is.
 *
 * @param target what it should be; empty where it only tells
 * @param met whether the target is met, or null where there is none or nothing could be measured
 */
record Measure(Kind kind, String what, String target, String measured, Boolean met) {

    /** What a number says of the program, and what of the machine. */
    enum Kind {
        /** A ratio of two times of one run, or a count: much the same on any machine. */
        RATIO,
        /** What people notice: the limit is theirs, and a slow machine may miss it. */
        NOTICED,
        /** A time of this machine. */
        TIME
    }

    /** A ratio or a count that should be at most {@code most}. */
    static Measure ratioAtMost(String what, double most, String unit, double measured) {
        return atMost(Kind.RATIO, what, most, unit, measured);
    }

    /** A ratio or a count that should be at least {@code least}. */
    static Measure ratioAtLeast(String what, double least, String unit, double measured) {
        return atLeast(Kind.RATIO, what, least, unit, measured);
    }

    /** A time that nobody notices if it is at most {@code most}. */
    static Measure noticedAtMost(String what, double most, String unit, double measured) {
        return atMost(Kind.NOTICED, what, most, unit, measured);
    }

    /** A rate that is smooth if it is at least {@code least}. */
    static Measure noticedAtLeast(String what, double least, String unit, double measured) {
        return atLeast(Kind.NOTICED, what, least, unit, measured);
    }

    /** A time that has no target. */
    static Measure time(String what, String unit, double measured) {
        return new Measure(Kind.TIME, what, "", number(measured) + " " + unit, null);
    }

    /** Something that could not be measured here, and why. */
    static Measure missing(Kind kind, String what, String why) {
        return new Measure(kind, what, "", why, null);
    }

    private static Measure atMost(Kind kind, String what, double most, String unit, double measured) {
        return new Measure(
                kind, what, "at most " + number(most) + " " + unit, number(measured) + " " + unit, measured <= most);
    }

    private static Measure atLeast(Kind kind, String what, double least, String unit, double measured) {
        return new Measure(
                kind, what, "at least " + number(least) + " " + unit, number(measured) + " " + unit, measured >= least);
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
        return kind == Kind.TIME
                ? "| " + what + " | " + measured + " |\n"
                : "| " + what + " | " + target + " | " + measured + " | " + verdict + " |\n";
    }
}
