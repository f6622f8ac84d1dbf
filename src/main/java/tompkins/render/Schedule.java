package tompkins.render;

/** Decides which samples are taken. All threads ask it how far the picture is, one at a time, between passes, for the next. */
interface Schedule {

    /** The next pass, or null if the picture is done. */
    Pass next(Film film);

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
