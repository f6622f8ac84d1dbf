package tompkins.trace;

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

    /**
     * Takes one sample of each pixel that is wanted, or of the first ones if it has stopped; the memory is used again
     * for the next ones of the block.
     */
    void take(BlockSamples samples);
}
