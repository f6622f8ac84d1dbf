package tompkins.render;

import java.util.function.LongSupplier;

/** How long a render may take, from now. */
final class TimeBudget {

    private final LongSupplier nanoClock;
    private final long start;
    private final double seconds;

    /** A budget; infinite if there is no limit. */
    TimeBudget(double seconds) {
        this(seconds, System::nanoTime);
    }

    /** A budget by some clock, which counts nanoseconds. */
    TimeBudget(double seconds, LongSupplier nanoClock) {
        this.seconds = seconds;
        this.nanoClock = nanoClock;
        start = nanoClock.getAsLong();
    }

    boolean isLimited() {
        return seconds < Double.POSITIVE_INFINITY;
    }

    boolean isOver() {
        return isLimited() && left() <= 0;
    }

    /** Seconds since the start. */
    double spent() {
        return (nanoClock.getAsLong() - start) / 1e9;
    }

    /** Seconds until the end; 0 after it. */
    double left() {
        return Math.max(0, seconds - spent());
    }
}
