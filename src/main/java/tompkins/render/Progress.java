package tompkins.render;

import java.util.concurrent.CancellationException;

/** Where work in the background says how far it is, and asks whether it is still wanted. */
public interface Progress {

    /** The share of the work that is done, from 0 to 1. */
    void setProgress(double share);

    /** Whether the work is to end early. */
    boolean isCancelled();

    /**
     * Ends work that is to end early.
     *
     * @throws CancellationException if it is
     */
    default void requireWanted() {
        if (isCancelled()) {
            throw new CancellationException();
        }
    }
}
