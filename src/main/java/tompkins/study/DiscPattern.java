package tompkins.study;

import java.util.SplittableRandom;
import org.hipparchus.analysis.integration.gauss.GaussIntegrator;
import org.hipparchus.analysis.integration.gauss.GaussIntegratorFactory;

/**
 * A pattern made for the disc, from a table, turned in each pixel. Where the place in the pixel varies too, the places are
 * those of {@link SamplingMethod#ADDITIVE}, paired with the points of the disc at random.
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

    private DiscPattern(long seed, double[] radii, double[] angles, double[] weights, boolean pixelToo) {
        super(seed);
        this.weights = weights;
        discX = new double[radii.length];
        discY = new double[radii.length];
        for (int i = 0; i < radii.length; i++) {
            discX[i] = radii[i] * Math.cos(angles[i]);
            discY[i] = radii[i] * Math.sin(angles[i]);
        }
        pixelPlaces = pixelToo ? ShiftedPattern.additive(seed, radii.length, true) : null;
    }

    /** {@link SamplingMethod#VOGEL} (Vogel 1979). */
    static DiscPattern vogel(long seed, int samples, boolean pixelToo) {
        double[] radii = new double[samples];
        double[] angles = new double[samples];
        double[] weights = new double[samples];
        for (int i = 0; i < samples; i++) {
            radii[i] = Math.sqrt((i + 0.5) / samples);
            angles[i] = i * GOLDEN_ANGLE;
            weights[i] = 1;
        }
        return new DiscPattern(seed, radii, angles, weights, pixelToo);
    }

    /** {@link SamplingMethod#GAUSS}: four times as many angles as radii, at least. */
    static DiscPattern gauss(long seed, int samples, boolean pixelToo) {
        int rings = Math.max(1, (int) Math.round(Math.sqrt(samples) / 2));
        int spokes = samples / rings;
        GaussIntegrator rule = new GaussIntegratorFactory().legendre(rings, 0, 1);
        double[] radii = new double[rings * spokes];
        double[] angles = new double[rings * spokes];
        double[] weights = new double[rings * spokes];
        for (int i = 0; i < radii.length; i++) {
            int ring = i % rings;
            radii[i] = Math.sqrt(rule.getPoint(ring));
            angles[i] = 2 * Math.PI * (i / rings) / spokes;
            weights[i] = rule.getWeight(ring);
        }
        return new DiscPattern(seed, radii, angles, weights, pixelToo);
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
        }
    }
}
