package tompkins.study;

import tompkins.camera.PixelSampler;
import tompkins.camera.SamplePlaces;

/** {@link SamplingMethod#SOBOL}: the sampler that pictures are taken with. */
final class ProgramPattern extends SamplePattern {

    private final SamplePlaces place = new SamplePlaces(1);
    private final PixelSampler sampler;
    private final SampledSpace space;
    private int column;
    private int row;

    ProgramPattern(long seed, SampledSpace space) {
        super(seed);
        sampler = new PixelSampler(seed, space.hasLens(), space.hasTime());
        this.space = space;
    }

    @Override
    void startPixel(int pixelColumn, int pixelRow) {
        column = pixelColumn;
        row = pixelRow;
    }

    @Override
    void goTo(int sample) {
        place.clear();
        place.addPixel(column, row);
        sampler.choose(place, sample);
        lensX = place.lensX(0);
        lensY = place.lensY(0);
        moment = place.moment(0);
        if (space.hasPixel()) {
            x = place.x(0) - column;
            y = place.y(0) - row;
        }
    }
}
