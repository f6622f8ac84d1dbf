package tompkins.study;

import tompkins.camera.PixelSampler;

/** {@link SamplingMethod#SOBOL}: the sampler that pictures are taken with. */
final class ProgramPattern extends SamplePattern {

    private final PixelSampler sampler;
    private final boolean pixelToo;
    private int column;
    private int row;

    ProgramPattern(long seed, boolean pixelToo) {
        super(seed);
        sampler = new PixelSampler(seed, true);
        this.pixelToo = pixelToo;
    }

    @Override
    void startPixel(int pixelColumn, int pixelRow) {
        column = pixelColumn;
        row = pixelRow;
    }

    @Override
    void goTo(int sample) {
        sampler.start(column, row, sample);
        lensX = sampler.lensX();
        lensY = sampler.lensY();
        if (pixelToo) {
            x = sampler.x() - column;
            y = sampler.y() - row;
        }
    }
}
