package tompkins.trace;

import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Watches the path of a ray. An observer must not keep what it is given: its memory is used again. */
interface PathObserver {

    /** What follows, until {@link #returns()}, is the life of a weaker branch of a ray that was split. */
    default void branches() {}

    /** The life of that branch is over: the branch that it came from goes on. */
    default void returns() {}

    /** A ray starts in the camera frame. */
    default void starts(Ray ray) {}

    /** The ray crosses into the scene frame, where it starts as the given ray. */
    default void crosses(Ray ray) {}

    /**
     * The ray, or one that came from it, hits something.
     *
     * @param frame whether this is in the camera frame, or in the scene
     * @param primitive what was hit
     */
    default void hits(Frame frame, Ray ray, Hit hit, Primitive primitive) {}

    /** The ray, or one that came from it, goes on and meets nothing else in a frame. */
    default void leaves(Frame frame, Ray ray) {}
}
