package tompkins.render;

/**
 * How many samples a preview may have: as many as let pictures follow each other in the wanted time, with all that a
 * picture needs of the processors, such as painting the previous one. A busy machine shows fewer pictures rather than
 * blurred ones: they get the samples that the greatest recent speed would allow, until they are good enough.
 */
final class PreviewBudget {

    /** With this many samples of a pixel a picture is good enough to be looked at. */
    private static final double GOOD_ENOUGH = 0.165;

    /** What is left of the greatest speed after each picture. */
    private static final double FADING = 0.98;

    /** More samples of a pixel than this show nothing new. */
    private static final double MOST = 0.4;

    /** The largest factor by which a picture may have more samples than the one before, or fewer. */
    private static final double STEP = 1.2;

    /** Samples in a second. */
    private double rate;

    /** Samples of a pixel that the time allows. */
    private double fraction = GOOD_ENOUGH;

    /**
     * The most samples of a picture, including its first.
     *
     * @param speed samples in a second with which the first of the picture were taken
     * @param seconds how long a picture may take
     */
    synchronized long most(double speed, double seconds, int pixels) {
        rate = Math.max(speed, FADING * rate);
        // where rays are slow the picture is coarse, so that it still follows the hand
        double needed = Math.min(GOOD_ENOUGH * pixels, seconds * rate);
        return (long) Math.max(fraction > GOOD_ENOUGH ? fraction * pixels : 0, needed);
    }

    /**
     * Takes note of a picture. One that took much too long may have waited for other programs, so that a single one
     * changes little.
     *
     * @param took how long it took, until the next one could begin, in seconds
     * @param seconds how long it might have taken
     */
    synchronized void ended(double took, double seconds) {
        // the square root, since only a part of the time is that of the rays, and each picture is another one
        double change = Math.max(1 / STEP, Math.min(STEP, Math.sqrt(seconds / took)));
        fraction = Math.max(GOOD_ENOUGH, Math.min(MOST, fraction * change));
    }
}
