package tompkins.render;

import java.util.function.BooleanSupplier;

/**
 * Decides which samples are taken. The next pass is asked for by one thread at a time, between passes; how far the
 * picture is, by any thread at any time.
 */
interface Schedule {

    /**
     * The next pass, or null if the picture is done.
     *
     * @param stopped whether nobody wants it any more
     * @throws java.util.concurrent.CancellationException if nobody does
     */
    Pass next(Film film, BooleanSupplier stopped);

    /** The root mean square error at which the picture is done, unless its samples end before; 0 if none is wanted. */
    double wantedError();

    /**
     * How much of the picture is done.
     *
     * @param work the {@link Pass#work()} that is done
     * @return from 0 to 1
     */
    double progress(double work);

    /** Whether no new part of a pass shall be begun because the time is over. */
    boolean isOver();
}
