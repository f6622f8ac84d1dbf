package tompkins.study;

import java.util.SplittableRandom;

/** {@link SamplingMethod#JITTERED}; cells of the pixel, the lens and the time are paired at random. */
final class JitteredPattern extends SamplePattern {

    private final int samples;
    private final int columns;
    private final int rows;
    private final SampledSpace space;
    private SplittableRandom random;
    private int[] pairs;
    private int[] moments;

    JitteredPattern(long seed, int samples, SampledSpace space) {
        super(seed);
        this.samples = samples;
        columns = (int) Math.ceil(Math.sqrt(samples));
        rows = (samples + columns - 1) / columns;
        this.space = space;
    }

    @Override
    void startPixel(int column, int row) {
        random = randomFor(column, row);
        pairs = space.hasPixel() ? shuffled(samples, random) : null;
        moments = space.hasTime() ? shuffled(samples, random) : null;
    }

    @Override
    void goTo(int sample) {
        if (space.hasLens()) {
            lens(across(sample), up(sample));
        }
        if (space.hasTime()) {
            moment = (moments[sample] + random.nextDouble()) / samples;
        }
        if (space.hasPixel()) {
            x = across(pairs[sample]);
            y = up(pairs[sample]);
        }
    }

    private double across(int cell) {
        return (cell % columns + random.nextDouble()) / columns;
    }

    private double up(int cell) {
        return (cell / columns + random.nextDouble()) / rows;
    }
}
