package tompkins.trace;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** Ends work that is no longer wanted, so that whoever cancelled it need not wait. */
public final class Cancellation {

    private Cancellation() {}

    /**
     * Ends the work if it is no longer wanted.
     *
     * @throws CancellationException if {@code unwanted} says so
     */
    public static void stopIf(BooleanSupplier unwanted) {
        if (unwanted.getAsBoolean()) {
            throw new CancellationException();
        }
    }
}
