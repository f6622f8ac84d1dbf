package tompkins.shutter;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** A shutter that opens line after line: line k from the first of n opens later by {@code sweep (k + 1/2)/n}. */
@Meaning("How the shutter runs across the picture, which opens line after line")
public record RollingShutter(
        @Meaning("The way in which it runs: from the first line, which opens first, to the last")
        SweepDirection direction,

        @Meaning(
                value =
                        "Time that it takes from edge to edge of the picture, 0 to 1e50; with 0 all lines open together",
                unit = "time")
        double sweep) {

    /** All lines open together. */
    public static final RollingShutter DEFAULT = new RollingShutter(SweepDirection.DOWN, 0);

    /** Checks both values. */
    public RollingShutter {
        Require.duration("sweep", sweep);
    }

    /** Whether lines open one after the other. */
    public boolean rolls() {
        return sweep > 0;
    }

    /**
     * How much later than the shutter model says a line opens.
     *
     * @param middle its middle, in rows from the top or in columns from the left: 0.5 for the first
     * @param lines how many rows or columns the picture has
     */
    public double delay(double middle, int lines) {
        double fromFirst = direction.beginsAtFirst() ? middle : lines - middle;
        return sweep * (fromFirst / lines);
    }
}
