package tompkins.study;

/** The centres of the cells of a grid in the pixel, the same in all pixels; through the centre of the lens. */
final class GridPattern extends SamplePattern {

    private final int side;

    /** A grid of about the given number of samples. */
    GridPattern(int samples) {
        super(0);
        side = (int) Math.round(Math.sqrt(samples));
    }

    @Override
    void startPixel(int column, int row) {
        // the same everywhere
    }

    @Override
    void goTo(int sample) {
        x = (sample % side + 0.5) / side;
        y = (sample / side + 0.5) / side;
    }
}
