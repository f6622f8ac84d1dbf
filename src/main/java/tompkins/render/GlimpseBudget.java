package tompkins.render;

/**
 * How many samples a glimpse may have. The greatest speed of late counts: a machine that does other things meanwhile
 * shows fewer pictures, not coarser ones.
 */
final class GlimpseBudget {

    /** With this many samples of a pixel a picture can be looked at. */
    private static final double GOOD_ENOUGH = 0.2;

    /** A picture that is not good enough may take so many times as long as others. */
    private static final double PATIENCE = 3;

    /** What is left of the greatest speed after each picture. */
    private static final double FADING = 0.98;

    /** Samples in a second. */
    private double rate;

    /**
     * The most samples of a picture, including its first.
     *
     * @param first how many were taken first
     * @param firstSeconds how long these took
     * @param seconds how long all may take
     */
    synchronized long most(long first, double firstSeconds, double seconds, int pixels) {
        rate = Math.max(first / firstSeconds, FADING * rate);
        return (long) Math.max(rate * seconds, Math.min(GOOD_ENOUGH * pixels, rate * PATIENCE * seconds));
    }
}
