package tompkins.study;

import java.util.SplittableRandom;

/** The centres of the cells of a grid in the pixel, the same in all pixels; through the centre of the lens. */
final class GridPattern extends SamplePattern {

    private final int side;

    /** A grid of about the given number of samples. */
    GridPattern(int samples) {
        super(0);
        side = (int) Math.round(Math.sqrt(samples));
    }

    @Override
    void start(int pixel, SplittableRandom random) {
        // the same everywhere
    }

    @Override
    void go(int pixel, int sample, Position at) {
        at.x = (sample % side + 0.5) / side;
        at.y = (sample / side + 0.5) / side;
    }
}
