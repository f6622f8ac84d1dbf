package tompkins.surface;

/** The wave that is +1 on [0, 1), -1 on [1, 2), and so on: one direction of a chequerboard. */
final class SquareWave {

    /**
     * From this place on neighbouring numbers are a period apart or more, so that all lie on one value; and a window of
     * this half width holds equally much of both, to the last digit.
     */
    private static final double END = 0x1p53;

    private SquareWave() {}

    /**
     * The mean of the wave from {@code centre - half} to {@code centre + half}, by its integral, a triangle wave. It is
     * right to the rounding of the coordinates, even if the window is far narrower than a tile or holds millions of
     * them.
     */
    static double mean(double centre, double half) {
        // too wide or too far away for digits: the mean of the whole wave
        if (!(half < END && Math.abs(centre) < END)) {
            return 0;
        }
        // where the wave is seen as constant, its value; this also keeps half = 0 from a division by zero
        double lower = Math.floor(centre - half);
        if (lower == Math.floor(centre + half)) {
            return isOdd(lower) ? -1 : 1;
        }
        // the period is 2: both ends are taken back to the same period, so that their difference keeps its digits
        double periods = 2 * Math.floor((centre - half) / 2);
        double from = centre - half - periods;
        double to = centre + half - periods;
        return (integral(to) - integral(from)) / (2 * half);
    }

    /** Whether a whole number, which may be too large for an int, is odd: by its half, which is exact and fast. */
    static boolean isOdd(double whole) {
        return 2 * Math.floor(whole / 2) < whole;
    }

    /** Integral of the wave from 0 to {@code x >= 0}: rises to 1 at 1 and falls back to 0 at 2. */
    private static double integral(double x) {
        double phase = x - 2 * Math.floor(x / 2);
        return phase < 1 ? phase : 2 - phase;
    }
}
