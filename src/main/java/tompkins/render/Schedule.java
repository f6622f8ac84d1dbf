package tompkins.render;

import java.util.function.BooleanSupplier;

/**
 * Decides which samples are taken. One thread at a time asks for the next pass, between passes; any thread may ask at
 * any time how far the picture is.
 */
interface Schedule {

    /**
     * The next pass, or null if the picture is done.
     *
     * @param stopped whether the picture is no longer wanted
     * @throws java.util.concurrent.CancellationException if it is not
     */
    Pass next(BooleanSupplier stopped);

    /** The root mean square error at which the picture is done, unless its samples end before; 0 if none is wanted. */
    default double wantedError() {
        return 0;
    }

    /**
     * How much of the picture is done.
     *
     * @param work the {@link Pass#work()} that is done
     * @return from 0 to 1
     */
    double progress(double work);

    /** Whether no new part of a pass may be begun because the time is over. */
    default boolean isOver() {
        return false;
    }
}
