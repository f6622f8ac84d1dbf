package tompkins.study;

import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hipparchus.analysis.integration.gauss.GaussIntegrator;
import org.hipparchus.analysis.integration.gauss.GaussIntegratorFactory;

/**
 * A pattern made for the disc, from a table, turned in each pixel. Where the position in the pixel varies too, the
 * positions are those of {@link SamplingMethod#ADDITIVE}, paired with the points of the disc at random.
 */
final class DiscPattern {

    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private DiscPattern() {}

    /** {@link SamplingMethod#VOGEL} (Vogel 1979). */
    static SamplePattern vogel(long seed, int samples, SampledSpace space) {
        IntToDoubleFunction radius = i -> Math.sqrt((i + 0.5) / samples);
        return new SamplePattern(seed, turned(samples, radius, i -> i * GOLDEN_ANGLE, space));
    }

    /** {@link SamplingMethod#GAUSS}: four times as many angles as radii, at least. */
    static SamplePattern gauss(long seed, int samples, SampledSpace space) {
        int rings = Math.max(1, (int) Math.round(Math.sqrt(samples) / 2));
        int spokes = samples / rings;
        GaussIntegrator rule = new GaussIntegratorFactory().legendre(rings, 0, 1);
        IntToDoubleFunction radius = i -> Math.sqrt(rule.getPoint(i % rings));
        IntToDoubleFunction angle = i -> 2 * Math.PI * (i / rings) / spokes;
        return new SamplePattern(seed, turned(rings * spokes, radius, angle, space), i -> rule.getWeight(i % rings));
    }

    private static SamplePattern.Pixels turned(
            int samples, IntToDoubleFunction radius, IntToDoubleFunction angle, SampledSpace space) {
        double[] discX = table(samples, i -> radius.applyAsDouble(i) * Math.cos(angle.applyAsDouble(i)));
        double[] discY = table(samples, i -> radius.applyAsDouble(i) * Math.sin(angle.applyAsDouble(i)));
        SamplePattern.Pixels positions = space.hasPixel() ? ShiftedPattern.additive(samples, space) : null;
        return random -> {
            double turn = 2 * Math.PI * random.nextDouble();
            double cosine = Math.cos(turn);
            double sine = Math.sin(turn);
            int[] pairs = positions == null ? null : SamplePattern.shuffled(samples, random);
            SamplePattern.PixelSamples inPixel = positions == null ? null : positions.begin(random);
            return (sample, at) -> {
                if (inPixel != null) {
                    inPixel.go(pairs[sample], at);
                }
                at.lensX = cosine * discX[sample] - sine * discY[sample];
                at.lensY = sine * discX[sample] + cosine * discY[sample];
            };
        };
    }

    private static double[] table(int samples, IntToDoubleFunction value) {
        return IntStream.range(0, samples).mapToDouble(value).toArray();
    }
}
