package tompkins;

import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/** Waits for what other threads or processes do. */
public final class Waiting {

    private static final long LONGEST_NANOSECONDS = 300_000_000_000L;
    private static final long PAUSE_NANOSECONDS = 5_000_000;

    private Waiting() {}

    /**
     * Waits until something is true, and fails if it is not after five minutes.
     *
     * @param what that is waited for, in words
     */
    public static void until(String what, BooleanSupplier condition) {
        long start = System.nanoTime();
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() - start > LONGEST_NANOSECONDS) {
                throw new AssertionError("waited in vain for " + what);
            }
            LockSupport.parkNanos(PAUSE_NANOSECONDS);
        }
    }
}
