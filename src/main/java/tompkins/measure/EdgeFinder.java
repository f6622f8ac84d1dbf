package tompkins.measure;

/** Finds an edge in a profile, between two samples: where it passes half of the step between both sides. */
public final class EdgeFinder {

    private EdgeFinder() {}

    /** Samples on each side whose means are compared to find a step. */
    private static final int SIDE = 5;

    /**
     * The place of the largest step, counted in samples from the first; NaN if there is none. A step is the difference
     * between the means of a few samples on both sides, so that slow changes, such as those by shading, do not count;
     * the place between two samples is interpolated linearly.
     *
     * @param values the profile; what is not finite has no step
     */
    public static double edge(double... values) {
        int count = values.length;
        int side = Math.max(1, Math.min(SIDE, count / 2));
        int after = 0;
        double best = 0;
        double largest = 0;
        for (int i = 1; i < count; i++) {
            double step = Math.abs(mean(values, Math.max(0, i - side), i) - mean(values, i, Math.min(count, i + side)));
            largest = Math.max(largest, Math.abs(values[i]));
            if (step > best) {
                best = step;
                after = i;
            }
        }
        if (after == 0 || !(best > 1e-12 * largest)) {
            return Double.NaN;
        }
        double left = mean(values, Math.max(0, after - side), after);
        double right = mean(values, after, Math.min(count, after + side));
        return crossing(values, (left + right) / 2, after - 0.5);
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
