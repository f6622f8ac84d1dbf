package tompkins.study;

import java.util.SplittableRandom;

/** {@link SamplingMethod#JITTERED}; cells of the pixel, the lens and the time are paired at random. */
final class JitteredPattern extends SamplePattern {

    private final int samples;
    private final int columns;
    private final int rows;
    private final SampledSpace space;
    private final SplittableRandom[] randoms = new SplittableRandom[PIXELS];
    private final int[][] pairs = new int[PIXELS][];
    private final int[][] moments = new int[PIXELS][];

    JitteredPattern(long seed, int samples, SampledSpace space) {
        super(seed);
        this.samples = samples;
        columns = (int) Math.ceil(Math.sqrt(samples));
        rows = (samples + columns - 1) / columns;
        this.space = space;
    }

    @Override
    void start(int pixel, SplittableRandom random) {
        randoms[pixel] = random;
        pairs[pixel] = space.hasPixel() ? shuffled(samples, random) : null;
        moments[pixel] = space.hasTime() ? shuffled(samples, random) : null;
    }

    @Override
    void go(int pixel, int sample, Position at) {
        SplittableRandom random = randoms[pixel];
        if (space.hasLens()) {
            at.goToLens(across(sample, random), up(sample, random));
        }
        if (space.hasTime()) {
            at.moment = (moments[pixel][sample] + random.nextDouble()) / samples;
        }
        if (space.hasPixel()) {
            at.x = across(pairs[pixel][sample], random);
            at.y = up(pairs[pixel][sample], random);
        }
    }

    private double across(int cell, SplittableRandom random) {
        return (cell % columns + random.nextDouble()) / columns;
    }

    private double up(int cell, SplittableRandom random) {
        return (cell / columns + random.nextDouble()) / rows;
    }
}
