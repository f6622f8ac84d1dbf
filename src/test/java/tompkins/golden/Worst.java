package tompkins.golden;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The row on which a method does worst.
 *
 * @param excess error divided by the limit of the row: at most 1 if all rows pass
 * @param id the row
 * @param rows number of rows that were looked at
 */
public record Worst(double excess, String id, int rows) {

    /** The largest value of a function over rows; values that are no numbers are worse than all numbers. */
    public static Worst of(List<GoldenRow> rows, ToDoubleFunction<GoldenRow> errorOverLimit) {
        double excess = -1;
        String id = "no row";
        for (GoldenRow row : rows) {
            double value = errorOverLimit.applyAsDouble(row);
            double comparable = Double.isNaN(value) ? Double.POSITIVE_INFINITY : value;
            if (comparable > excess) {
                excess = comparable;
                id = row.id();
            }
        }
        return new Worst(excess, id, rows.size());
    }

    /** An error as a share of its limit; no error is within any limit. */
    public static double share(double error, double limit) {
        return error == 0 ? 0 : error / limit;
    }

    /** Whether all rows pass. */
    public boolean passes() {
        return rows > 0 && excess >= 0 && excess <= 1;
    }
}
