package tompkins.study;

import java.util.SplittableRandom;

/** {@link SamplingMethod#RANDOM}. */
final class RandomPattern extends SamplePattern {

    private final boolean pixelToo;
    private SplittableRandom random;

    RandomPattern(long seed, boolean pixelToo) {
        super(seed);
        this.pixelToo = pixelToo;
    }

    @Override
    void startPixel(int column, int row) {
        random = randomFor(column, row);
    }

    @Override
    void goTo(int sample) {
        if (pixelToo) {
            x = random.nextDouble();
            y = random.nextDouble();
        }
        do {
            lensX = 2 * random.nextDouble() - 1;
            lensY = 2 * random.nextDouble() - 1;
        } while (lensX * lensX + lensY * lensY > 1);
    }
}
