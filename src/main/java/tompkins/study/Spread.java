package tompkins.study;

import java.util.Arrays;

/**
 * A figure that was measured several times.
 *
 * @param low the smallest value
 * @param middle the median
 * @param high the largest value
 */
public record Spread(double low, double middle, double high) {

    /** A figure that is known, or was measured only once. */
    public static Spread exact(double value) {
        return new Spread(value, value, value);
    }

    /**
     * The spread of some values.
     *
     * @throws IllegalArgumentException if there are none
     */
    public static Spread of(double... values) {
        if (values.length == 0) {
            throw new IllegalArgumentException("a spread needs at least one value");
        }
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int middle = sorted.length / 2;
        double median = sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
        return new Spread(sorted[0], median, sorted[sorted.length - 1]);
    }
}
