package tompkins.render;

/** How long a render may take, from now. */
final class TimeBudget {

    private final long start = System.nanoTime();
    private final double seconds;

    /** A budget; infinite if there is no limit. */
    TimeBudget(double seconds) {
        this.seconds = seconds;
    }

    boolean isLimited() {
        return seconds < Double.POSITIVE_INFINITY;
    }

    boolean isOver() {
        return isLimited() && left() <= 0;
    }

    /** Seconds since the start. */
    double spent() {
        return (System.nanoTime() - start) / 1e9;
    }

    /** Seconds until the end; 0 after it. */
    double left() {
        return Math.max(0, seconds - spent());
    }
}
