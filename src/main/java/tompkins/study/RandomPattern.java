package tompkins.study;

import java.util.SplittableRandom;

/** {@link SamplingMethod#RANDOM}. */
final class RandomPattern extends SamplePattern {

    private final SampledSpace space;
    private final SplittableRandom[] randoms = new SplittableRandom[PIXELS];

    RandomPattern(long seed, SampledSpace space) {
        super(seed);
        this.space = space;
    }

    @Override
    void start(int pixel, SplittableRandom random) {
        randoms[pixel] = random;
    }

    @Override
    void go(int pixel, int sample, Position at) {
        SplittableRandom random = randoms[pixel];
        if (space.hasPixel()) {
            at.x = random.nextDouble();
            at.y = random.nextDouble();
        }
        if (space.hasTime()) {
            at.moment = random.nextDouble();
        }
        if (space.hasLens()) {
            do {
                at.lensX = 2 * random.nextDouble() - 1;
                at.lensY = 2 * random.nextDouble() - 1;
            } while (at.lensX * at.lensX + at.lensY * at.lensY > 1);
        }
    }
}
