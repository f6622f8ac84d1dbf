package tompkins.study;

import java.util.SplittableRandom;

/** {@link SamplingMethod#RANDOM}. */
final class RandomPattern extends SamplePattern {

    private final SampledSpace space;
    private SplittableRandom random;

    RandomPattern(long seed, SampledSpace space) {
        super(seed);
        this.space = space;
    }

    @Override
    void startPixel(int column, int row) {
        random = randomFor(column, row);
    }

    @Override
    void goTo(int sample) {
        if (space.hasPixel()) {
            x = random.nextDouble();
            y = random.nextDouble();
        }
        if (space.hasTime()) {
            moment = random.nextDouble();
        }
        if (space.hasLens()) {
            throughLens();
        }
    }

    private void throughLens() {
        do {
            lensX = 2 * random.nextDouble() - 1;
            lensY = 2 * random.nextDouble() - 1;
        } while (lensX * lensX + lensY * lensY > 1);
    }
}
