package tompkins.study;

import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * A spiral made for the disc (Vogel 1979), turned in each pixel. Where the position in the pixel varies too, the
 * positions are those of {@link SamplingMethod#ADDITIVE}, paired with the points of the disc at random.
 */
final class DiscPattern {

    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private DiscPattern() {}

    /** {@link SamplingMethod#VOGEL}. */
    static SamplePattern.Pixels vogel(int samples, SampledSpace space) {
        IntToDoubleFunction radius = i -> Math.sqrt((i + 0.5) / samples);
        double[] discX = table(samples, i -> radius.applyAsDouble(i) * Math.cos(i * GOLDEN_ANGLE));
        double[] discY = table(samples, i -> radius.applyAsDouble(i) * Math.sin(i * GOLDEN_ANGLE));
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
