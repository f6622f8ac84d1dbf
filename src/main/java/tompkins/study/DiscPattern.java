package tompkins.study;

import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hipparchus.analysis.integration.gauss.GaussIntegrator;
import org.hipparchus.analysis.integration.gauss.GaussIntegratorFactory;

/**
 * A pattern made for the disc, from a table, turned in each pixel. Where the place in the pixel varies too, the places
 * are those of {@link SamplingMethod#ADDITIVE}, paired with the points of the disc at random.
 */
final class DiscPattern extends SamplePattern {

    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private final double[] discX;
    private final double[] discY;
    private final double[] weights;
    private final ShiftedPattern pixelPlaces;
    private double cosine;
    private double sine;
    private int[] pairs;

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
        pixelPlaces = space.hasPixel() ? ShiftedPattern.additive(seed, samples, space) : null;
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
    void startPixel(int column, int row) {
        SplittableRandom random = randomFor(column, row);
        double turn = 2 * Math.PI * random.nextDouble();
        cosine = Math.cos(turn);
        sine = Math.sin(turn);
        if (pixelPlaces != null) {
            pairs = shuffled(discX.length, random);
            pixelPlaces.startPixel(column, row);
        }
    }

    @Override
    void goTo(int sample) {
        lensX = cosine * discX[sample] - sine * discY[sample];
        lensY = sine * discX[sample] + cosine * discY[sample];
        weight = weights[sample];
        if (pixelPlaces != null) {
            pixelPlaces.goTo(pairs[sample]);
            x = pixelPlaces.x;
            y = pixelPlaces.y;
            moment = pixelPlaces.moment;
        }
    }
}
