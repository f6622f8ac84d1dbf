package tompkins.study;

import java.util.SplittableRandom;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;
import tompkins.ray.RayPacket;

/**
 * A way to choose positions, at work on the blocks of pixels that the renderer follows. Like the program's own sampler,
 * a pattern depends on the seed and the pixel.
 */
final class SamplePattern implements Sampler {

    /** Pixels of a block. */
    static final int PIXELS = RayPacket.MOST;

    /** The samples of one pixel. */
    @FunctionalInterface
    interface PixelSamples {

        /** Puts the position of a sample where it belongs; samples come in their order. */
        void go(int sample, Position at);
    }

    /** Begins pixels. */
    @FunctionalInterface
    interface Pixels {

        /** The samples of a pixel, from a generator of its own. */
        PixelSamples begin(SplittableRandom random);
    }

    private final long seed;
    private final Pixels pixels;
    private final PixelSamples[] block = new PixelSamples[PIXELS];
    private final Position position = new Position();

    /** A pattern of the samples of pixels. */
    SamplePattern(long seed, Pixels pixels) {
        this.seed = seed;
        this.pixels = pixels;
    }

    @Override
    public void choose(SamplePositions positions, int sample) {
        for (int i = 0; i < positions.count(); i++) {
            if (sample == 0) {
                block[i] = pixels.begin(randomFor(positions.column(i), positions.row(i)));
            }
            block[i].go(sample, position);
            positions.choose(i, position.x, position.y, position.lensX, position.lensY, position.moment);
        }
    }

    private SplittableRandom randomFor(int column, int row) {
        // the seed itself is not well mixed, but the first number of a generator is
        long mixed = new SplittableRandom(seed * 0x9e3779b97f4a7c15L + ((long) row << 32 | column)).nextLong();
        return new SplittableRandom(mixed);
    }
}
