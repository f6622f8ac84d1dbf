package tompkins.study;

import java.util.SplittableRandom;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.ray.RayPacket;

/**
 * A way to choose positions, at work on the blocks of pixels that the renderer follows. Like the program's own sampler,
 * a pattern depends on the seed and the pixel; what it keeps for each pixel of a block is made at the first sample.
 */
abstract class SamplePattern implements Sampler {

    /** Pixels of a block. */
    static final int PIXELS = RayPacket.MOST;

    private final long seed;
    private final Position position = new Position();

    SamplePattern(long seed) {
        this.seed = seed;
    }

    @Override
    public void choose(SamplePositions positions, int sample) {
        for (int i = 0; i < positions.count(); i++) {
            if (sample == 0) {
                start(i, randomFor(positions.column(i), positions.row(i)));
            }
            go(i, sample, position);
            positions.choose(i, position.x, position.y, position.lensX, position.lensY, position.moment);
        }
    }

    /**
     * Begins a pixel.
     *
     * @param pixel its number in the block, below {@link #PIXELS}
     * @param random a generator of its own
     */
    abstract void start(int pixel, SplittableRandom random);

    /** Puts the position of a sample where it belongs. */
    abstract void go(int pixel, int sample, Position at);

    /** The weight of a sample in the mean of its pixel; 1 but for rules that have weights of their own. */
    static double weight(Sampler sampler, int sample) {
        return sampler instanceof DiscPattern disc ? disc.weight(sample) : 1;
    }

    private SplittableRandom randomFor(int column, int row) {
        // the seed itself is not well mixed, but the first number of a generator is
        long mixed = new SplittableRandom(seed * 0x9e3779b97f4a7c15L + ((long) row << 32 | column)).nextLong();
        return new SplittableRandom(mixed);
    }

    /** The numbers from 0 to below {@code count} in random order. */
    static int[] shuffled(int count, SplittableRandom random) {
        int[] order = new int[count];
        for (int i = 0; i < count; i++) {
            int j = random.nextInt(i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }

    /** The sum without its whole part. */
    static double wrapped(double value, double shift) {
        double sum = value + shift;
        return sum - Math.floor(sum);
    }
}
