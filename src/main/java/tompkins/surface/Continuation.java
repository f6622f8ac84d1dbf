package tompkins.surface;

/** What becomes of the rays that meet a surface; a later one says more. */
public enum Continuation {
    /** They end here. */
    NONE,
    /** Light comes from straight behind, as through a filter. */
    STRAIGHT,
    /** They turn, so that what they meet is seen elsewhere than it is: mirrors, glass, windows, lenses. */
    TURNED;

    /** What becomes of the rays of a surface that behaves like this at some points, and like the other at the rest. */
    Continuation orElsewhere(Continuation other) {
        return compareTo(other) < 0 ? other : this;
    }
}
