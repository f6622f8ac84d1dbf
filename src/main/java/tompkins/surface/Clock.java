package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * A dial that shows the proper time of its own object: each point of it the time at which the light left that point, so
 * that the hands of fast clocks look bent. The hand turns once in a period, clockwise, and points up at 0.
 */
@Meaning("A dial on the coordinates 0 to 1 that shows the proper time of its own object; each point shows its own time")
public record Clock(
        @Meaning(value = "Time in which the hand turns once", unit = "time")
        double period,

        @Meaning("Surface of the dial") Surface face,

        @Meaning("Surface of the hand, the marks and the digits")
        Surface hand,

        @Meaning("Whether digits below the middle count the whole turns of the hand")
        boolean digits)
        implements CompositeSurface {

    /** A white dial. */
    public static final Clock DEFAULT = new Clock(
            1,
            new ColouredSurface(Colour.grey(0.9), Colour.BLACK),
            new ColouredSurface(Colour.grey(0.1), Colour.BLACK),
            false);

    // lengths in units of the dial's width
    private static final double HAND_LENGTH = 0.40;
    private static final double HALF_HAND_WIDTH = 0.03;
    private static final double MARK_START = 0.42;
    private static final double MARK_END = 0.48;
    private static final double HALF_MARK_WIDTH = 0.012;
    private static final int MARKS = 12;
    private static final double DIGITS_HEIGHT = 0.16;
    private static final double DIGITS_MIDDLE = -0.22;

    /** Checks all values. */
    public Clock {
        Require.positive("period", period);
    }

    @Override
    public Surface first() {
        return face;
    }

    @Override
    public Surface second() {
        return hand;
    }

    @Override
    public double fractionOfSecond(Ray ray, Hit hit) {
        double toRight = hit.coordinates.u() - 0.5;
        double up = hit.coordinates.v() - 0.5;
        double turns = hit.clockReading() / period;
        boolean marked = isHand(toRight, up, turns)
                || isMark(toRight, up)
                || digits
                        && SevenSegments.isLit(
                                Math.floor(turns), toRight / DIGITS_HEIGHT, (up - DIGITS_MIDDLE) / DIGITS_HEIGHT);
        return marked ? 1 : 0;
    }

    private static boolean isHand(double toRight, double up, double turns) {
        double angle = 2 * Math.PI * (turns - Math.floor(turns));
        double along = toRight * Math.sin(angle) + up * Math.cos(angle);
        double across = toRight * Math.cos(angle) - up * Math.sin(angle);
        return along >= 0 && along <= HAND_LENGTH && Math.abs(across) <= HALF_HAND_WIDTH;
    }

    private static boolean isMark(double toRight, double up) {
        double radius = Math.hypot(toRight, up);
        if (radius < MARK_START || radius > MARK_END) {
            return false;
        }
        double spacing = 2 * Math.PI / MARKS;
        double angle = Math.atan2(toRight, up);
        double fromMark = angle - spacing * Math.rint(angle / spacing);
        return radius * Math.abs(Math.sin(fromMark)) <= HALF_MARK_WIDTH;
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }

    @Override
    public boolean showsTime() {
        return true;
    }
}
