package tompkins.measure;

/** Finds an edge in a profile, between two samples: where it passes half of the step between both sides. */
public final class EdgeFinder {

    private EdgeFinder() {}

    /**
     * The place of the largest step, counted in samples from the first; NaN if there is none. The two sides are those
     * whose means leave the least squares; the place between two samples is interpolated linearly.
     *
     * @param values the profile; what is not finite keeps it from having an edge
     */
    public static double edge(double... values) {
        int count = values.length;
        double sum = 0;
        double largest = 0;
        for (double value : values) {
            sum += value;
            largest = Math.max(largest, Math.abs(value));
        }
        int after = 0;
        double best = 0;
        double left = 0;
        for (int i = 1; i < count; i++) {
            left += values[i - 1];
            double step = left / i - (sum - left) / (count - i);
            double explained = step * step * i * (count - i);
            if (explained > best) {
                best = explained;
                after = i;
            }
        }
        if (after == 0 || !(Math.sqrt(best) > 1e-12 * largest * count)) {
            return Double.NaN;
        }
        double half = (mean(values, 0, after) + mean(values, after, count)) / 2;
        return crossing(values, half, after - 0.5);
    }

    private static double mean(double[] values, int from, int to) {
        double sum = 0;
        for (int i = from; i < to; i++) {
            sum += values[i];
        }
        return sum / (to - from);
    }

    /** Where the profile crosses a value, nearest to a place. */
    private static double crossing(double[] values, double level, double near) {
        double best = Double.NaN;
        for (int i = 1; i < values.length; i++) {
            double before = values[i - 1] - level;
            double after = values[i] - level;
            if (before * after <= 0 && before != after) {
                double place = i - 1 + before / (before - after);
                best = Double.isNaN(best) || Math.abs(place - near) < Math.abs(best - near) ? place : best;
            }
        }
        return best;
    }
}
