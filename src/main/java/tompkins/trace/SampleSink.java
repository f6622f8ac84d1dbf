package tompkins.trace;

import tompkins.ray.Colour;

/** Receives the samples of a block of pixels. */
public interface SampleSink {

    /** Whether a sample of a pixel is wanted; asked before its ray is made. */
    boolean wants(int column, int row);

    /** Whether nothing is wanted any more; asked before a ray is followed in each frame. */
    boolean isStopped();

    /** Takes the colour of one sample of a pixel, before exposure. */
    void take(int column, int row, Colour colour);
}
