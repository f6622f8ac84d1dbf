package tompkins.shutter;

/** The direction in which a {@link RollingShutter} runs across the picture. */
public enum SweepDirection {

    /** From the top row to the bottom row. */
    DOWN,

    /** From the bottom row to the top row. */
    UP,

    /** From the left column to the right column. */
    RIGHT,

    /** From the right column to the left column. */
    LEFT;

    /** Whether the lines are rows; otherwise they are columns. */
    public boolean runsOverRows() {
        return this == DOWN || this == UP;
    }

    /** Whether the first line is the top row or the left column, from which pixels are counted. */
    public boolean beginsAtFirst() {
        return this == DOWN || this == RIGHT;
    }
}
