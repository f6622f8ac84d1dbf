package tompkins.study;

import java.util.SplittableRandom;

/** {@link SamplingMethod#JITTERED}; cells of the pixel and of the lens are paired at random. */
final class JitteredPattern extends SamplePattern {

    private final int samples;
    private final int columns;
    private final int rows;
    private final boolean pixelToo;
    private SplittableRandom random;
    private int[] pairs;

    JitteredPattern(long seed, int samples, boolean pixelToo) {
        super(seed);
        this.samples = samples;
        columns = (int) Math.ceil(Math.sqrt(samples));
        rows = (samples + columns - 1) / columns;
        this.pixelToo = pixelToo;
    }

    @Override
    void startPixel(int column, int row) {
        random = randomFor(column, row);
        pairs = pixelToo ? shuffled(samples, random) : null;
    }

    @Override
    void goTo(int sample) {
        lens(across(sample), up(sample));
        if (pixelToo) {
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
