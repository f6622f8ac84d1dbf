package tompkins.trace;

import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Watches the path of a ray. An observer must not keep what it is given: its memory is used again. */
interface PathObserver {

    /** What follows, until {@link #returns()}, is the life of a weaker branch of a ray that was split. */
    default void branches() {}

    /** Whether the branch that is being followed need not be followed on, because its light does not count. */
    default boolean hasSeenEnough() {
        return false;
    }

    /** The life of that branch is over: the branch that it came from goes on. */
    default void returns() {}

    /** A ray starts in the camera frame. */
    default void starts(Ray ray) {}

    /** The ray crosses into the scene frame, where it starts as the given ray. */
    default void crosses(Ray ray) {}

    /**
     * The ray, or one that came from it, hits something.
     *
     * @param hit with the ray that has hit, and the primitive as its boundary
     */
    default void hits(Hit hit) {}

    /** The ray, or one that came from it, meets nothing else: in the camera frame, or in that of the scene. */
    default void leaves(Ray ray) {}
}
