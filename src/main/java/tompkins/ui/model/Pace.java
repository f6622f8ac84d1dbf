package tompkins.ui.model;

import java.time.Duration;

/** How soon a picture has to be on the screen, and how good. */
public enum Pace {
    /** Pictures follow a hand: each is shown at once, coarse if necessary, and gets finer until the next one comes. */
    HAND(Duration.ofMillis(30), Duration.ofMillis(30), Double.POSITIVE_INFINITY),

    /**
     * Pictures follow each other by themselves: each is shown once, as good as twelve a second allow, and is good
     * enough with a sample in each pixel.
     */
    FILM(Duration.ofMillis(80), Duration.ZERO, 1),

    /**
     * Pictures follow each other while somebody steers: each is a {@link tompkins.render.Renderer#startGlimpse
     * glimpse}, as good as thirty a second allow with a moment between them, and shown once.
     */
    RIDE(Duration.ofMillis(30), Duration.ZERO, 0),

    /**
     * The first picture after thrust has changed on a ride: a glimpse, before which the one in the making is dropped.
     */
    ANSWER(Duration.ofMillis(30), Duration.ZERO, 0);

    private final long patience;
    private final long frame;
    private final double enough;

    Pace(Duration patience, Duration frame, double enough) {
        this.patience = patience.toNanos();
        this.frame = frame.toNanos();
        this.enough = enough;
    }

    /** Whether each picture is a glimpse. */
    public boolean isGlimpse() {
        return enough == 0;
    }

    /** How long a glimpse may take, in seconds. */
    public double glimpseSeconds() {
        return patience * 1e-9;
    }

    /**
     * Whether to wait for a finer picture before anything is shown.
     *
     * @param samples mean number of samples of a pixel so far
     * @param finerAfter nanoseconds from the change to when the next finer picture is expected
     */
    public boolean waits(double samples, long finerAfter) {
        return samples < enough && finerAfter < patience;
    }

    /** How many nanoseconds after its beginning a picture that was shown may be replaced by a newer one. */
    public long frame() {
        return frame;
    }

    /** The least time in nanoseconds before a picture that has nothing to show may be replaced. */
    public long shortestChance() {
        return 2 * patience;
    }
}
