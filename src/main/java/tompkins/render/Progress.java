package tompkins.render;

import tompkins.trace.Cancellation;

/** Lets work in the background report how far it is, and ask whether it is still wanted. */
public interface Progress {

    /** The fraction of the work that is done, from 0 to 1. */
    void setProgress(double fraction);

    /** Whether the work should end early. */
    boolean isCancelled();

    /**
     * Ends work that should end early.
     *
     * @throws java.util.concurrent.CancellationException if it should
     */
    default void requireWanted() {
        Cancellation.stopIf(this::isCancelled);
    }
}
