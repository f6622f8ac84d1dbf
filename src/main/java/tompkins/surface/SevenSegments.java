package tompkins.surface;

/** Whole numbers in digits of seven segments each. */
final class SevenSegments {

    /** For each digit its segments, as bits: top, upper right, lower right, bottom, lower left, upper left, middle. */
    private static final int[] SEGMENTS = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};

    private static final int MINUS = 0x40;

    /** Width of a digit and distance to the next, in units of their height. */
    private static final double WIDTH = 0.5;

    private static final double PITCH = 0.7;
    private static final double HALF_THICKNESS = 0.06;

    private SevenSegments() {}

    /**
     * Whether a place belongs to the digits of a number, which are 1 high and have their middle at (0, 0).
     *
     * @param number a whole number
     */
    static boolean isLit(double number, double x, double y) {
        // what is longer than five characters is not shown
        if (Math.abs(y) > 0.5 + HALF_THICKNESS || !(number > -1e4 && number < 1e5)) {
            return false;
        }
        String text = Long.toString((long) number);
        double fromLeft = x + PITCH * text.length() / 2;
        int place = (int) Math.floor(fromLeft / PITCH);
        if (place < 0 || place >= text.length()) {
            return false;
        }
        char symbol = text.charAt(place);
        int segments = symbol == '-' ? MINUS : SEGMENTS[symbol - '0'];
        double acrossDigit = fromLeft - place * PITCH - PITCH / 2;
        return isInSegment(segments, acrossDigit, y);
    }

    private static boolean isInSegment(int segments, double x, double y) {
        double half = WIDTH / 2;
        return is(segments, 0) && isNear(x, y, -half, half, 0.5, 0.5)
                || is(segments, 1) && isNear(x, y, half, half, 0, 0.5)
                || is(segments, 2) && isNear(x, y, half, half, -0.5, 0)
                || is(segments, 3) && isNear(x, y, -half, half, -0.5, -0.5)
                || is(segments, 4) && isNear(x, y, -half, -half, -0.5, 0)
                || is(segments, 5) && isNear(x, y, -half, -half, 0, 0.5)
                || is(segments, 6) && isNear(x, y, -half, half, 0, 0);
    }

    private static boolean is(int segments, int bit) {
        return (segments >> bit & 1) == 1;
    }

    private static boolean isNear(double x, double y, double left, double right, double low, double high) {
        return x >= left - HALF_THICKNESS
                && x <= right + HALF_THICKNESS
                && y >= low - HALF_THICKNESS
                && y <= high + HALF_THICKNESS;
    }
}
