package tompkins.ui.model;

/** Lets something happen five times a second at most that could happen far more often. */
public final class Throttle {

    private static final long PAUSE_NANOSECONDS = 200_000_000L;

    private long last = System.nanoTime() - PAUSE_NANOSECONDS;

    /** Whether it may happen now; if so, it may not for a while. */
    public boolean admits() {
        long now = System.nanoTime();
        if (now - last < PAUSE_NANOSECONDS) {
            return false;
        }
        last = now;
        return true;
    }
}
