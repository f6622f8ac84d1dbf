package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hipparchus.analysis.integration.gauss.GaussIntegrator;
import org.hipparchus.analysis.integration.gauss.GaussIntegratorFactory;

/**
 * A pattern made for the disc, from a table, turned in each pixel. Where the position in the pixel varies too, the
 * positions are those of {@link SamplingMethod#ADDITIVE}, paired with the points of the disc at random.
 */
final class DiscPattern extends SamplePattern {

    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private final double[] discX;
    private final double[] discY;
    private final double[] weights;
    private final ShiftedPattern pixelPositions;
    private final double[] cosines = new double[PIXELS];
    private final double[] sines = new double[PIXELS];
    private final int[][] pairs = new int[PIXELS][];

    private DiscPattern(
            long seed,
            int samples,
            IntToDoubleFunction radius,
            IntToDoubleFunction angle,
            IntToDoubleFunction weight,
            SampledSpace space) {
        super(seed);
        discX = table(samples, i -> radius.applyAsDouble(i) * Math.cos(angle.applyAsDouble(i)));
        discY = table(samples, i -> radius.applyAsDouble(i) * Math.sin(angle.applyAsDouble(i)));
        weights = table(samples, weight);
        pixelPositions = space.hasPixel() ? ShiftedPattern.additive(seed, samples, space) : null;
    }

    private static double[] table(int samples, IntToDoubleFunction value) {
        return IntStream.range(0, samples).mapToDouble(value).toArray();
    }

    /** {@link SamplingMethod#VOGEL} (Vogel 1979). */
    static DiscPattern vogel(long seed, int samples, SampledSpace space) {
        return new DiscPattern(
                seed, samples, i -> Math.sqrt((i + 0.5) / samples), i -> i * GOLDEN_ANGLE, i -> 1, space);
    }

    /** {@link SamplingMethod#GAUSS}: four times as many angles as radii, at least. */
    static DiscPattern gauss(long seed, int samples, SampledSpace space) {
        int rings = Math.max(1, (int) Math.round(Math.sqrt(samples) / 2));
        int spokes = samples / rings;
        GaussIntegrator rule = new GaussIntegratorFactory().legendre(rings, 0, 1);
        return new DiscPattern(
                seed,
                rings * spokes,
                i -> Math.sqrt(rule.getPoint(i % rings)),
                i -> 2 * Math.PI * (i / rings) / spokes,
                i -> rule.getWeight(i % rings),
                space);
    }

    @Override
    void start(int pixel, SplittableRandom random) {
        double turn = 2 * Math.PI * random.nextDouble();
        cosines[pixel] = Math.cos(turn);
        sines[pixel] = Math.sin(turn);
        if (pixelPositions != null) {
            pairs[pixel] = shuffled(discX.length, random);
            pixelPositions.start(pixel, random);
        }
    }

    @Override
    void go(int pixel, int sample, Position at) {
        if (pixelPositions != null) {
            pixelPositions.go(pixel, pairs[pixel][sample], at);
        }
        at.lensX = cosines[pixel] * discX[sample] - sines[pixel] * discY[sample];
        at.lensY = sines[pixel] * discX[sample] + cosines[pixel] * discY[sample];
    }

    /** The weight of a sample in the mean of its pixel. */
    double weight(int sample) {
        return weights[sample];
    }
}
