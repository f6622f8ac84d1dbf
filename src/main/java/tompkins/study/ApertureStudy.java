package tompkins.study;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import tompkins.studio.Studio;

/**
 * How best to choose places on the lens, and in the pixel. The limits of the slopes follow from theory: the error of
 * independent places falls as N^(-1/2), that of one place in each cell as N^(-3/4) at an edge (Mitchell 1996), and as
 * N^(-5/8) if the edge also sweeps over the pixel.
 */
final class ApertureStudy extends SamplingStudy {

    private static final String INDEPENDENCE = "independence";
    private static final int SAMPLES_OF_INDEPENDENCE = 16;
    private static final double MOST_CORRELATION = 2;
    private static final String SPIRAL = SamplingMethod.VOGEL.title();

    /** The study, of photographs with a wide aperture; for the rest see {@link SamplingStudy}. */
    ApertureStudy(Map<String, Studio> studios, Comparison comparison) {
        super(studios, comparison, ExactProblems.OF_LENS, "wide aperture");
    }

    @Override
    public List<Trial> trials() {
        List<Trial> all = new ArrayList<>(super.trials());
        comparison()
                .methods()
                .forEach((title, factory) ->
                        all.add(new Trial(INDEPENDENCE, title, SAMPLES_OF_INDEPENDENCE, () -> independence(factory))));
        return all;
    }

    /**
     * Whether neighbouring pixels err independently: the variance of the mean error of pixels that see the same,
     * divided by what it is without any correlation. It is 1 for independent pixels and their number if all err alike.
     */
    private Figures independence(SamplingMethod.Factory factory) {
        int samples = SAMPLES_OF_INDEPENDENCE;
        ExactProblem edge = ExactProblems.ON_LENS;
        double[] errors =
                edge.errors(comparison().seed(), factory.sampler(comparison().seed(), samples, edge.space()), samples);
        double ofMeans = 0;
        double ofAll = 0;
        for (int i = 0; i < ExactProblem.INSTANCES; i++) {
            double mean = 0;
            for (int j = 0; j < ExactProblem.PIXELS_OF_INSTANCE; j++) {
                double error = errors[i * ExactProblem.PIXELS_OF_INSTANCE + j];
                mean += error / ExactProblem.PIXELS_OF_INSTANCE;
                ofAll += error * error / errors.length;
            }
            ofMeans += mean * mean / ExactProblem.INSTANCES;
        }
        return Figures.of(
                (double) samples * errors.length, Spread.exact(0), ofMeans / ofAll * ExactProblem.PIXELS_OF_INSTANCE);
    }

    @Override
    public void conclude(List<Measurement> all, Conclusion conclusion) {
        PowerLaw own = law(ExactProblems.ON_LENS, PROGRAM, all);
        conclusion.say(
                "aperture.answer",
                own.slope(),
                samplesFor(0.002, own),
                samplesFor(0.002, law(ExactProblems.ON_LENS, RANDOM, all)),
                samplesFor(0.002, law(ExactProblems.ON_LENS, SPIRAL, all)),
                law(ExactProblems.ON_LENS_AND_PIXEL, SPIRAL, all).slope(),
                law(ExactProblems.ON_LENS_AND_PIXEL, PROGRAM, all).slope());
        super.conclude(all, conclusion);
        double ratio = Measurement.of(INDEPENDENCE, PROGRAM, all).get(0).medianError();
        conclusion.demand(
                ratio < MOST_CORRELATION,
                "aperture.independence",
                MOST_CORRELATION,
                ExactProblem.PIXELS_OF_INSTANCE,
                ratio);
    }

    private static String samplesFor(double error, PowerLaw law) {
        double samples = Math.pow(error / law.factor(), 1 / law.slope());
        // those of a method that does not get better
        if (!Double.isFinite(samples)) {
            return "no number of";
        }
        return new BigDecimal(samples).round(new MathContext(2)).toBigInteger().toString();
    }
}
