package tompkins.trace;

import tompkins.ray.Colour;

/** Receives the samples of a block of pixels: all of them, unless it says otherwise. */
@FunctionalInterface
public interface SampleSink {

    /** Whether a sample of a pixel is wanted; asked before its ray is made. */
    default boolean wants(int column, int row) {
        return true;
    }

    /** Whether nothing is wanted any more; asked before a ray is followed in each frame. */
    default boolean isStopped() {
        return false;
    }

    /** Takes the colour of one sample of a pixel, before exposure. */
    void take(int column, int row, Colour colour);
}
