package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;

/** The slopes of theory, and what happens if a sampler is broken. */
class ApertureStudyTest {

    private static final String PROGRAM = SamplingStudy.PROGRAM;

    @Test
    void methodsFallAsTheoryAndTableSay() {
        SamplingStudy study = study(1024, SamplingMethod.all());
        List<StudyPoint> all = measure(study);
        assertThat(Conclusion.of(study, all).findings())
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
        // measured for 400 other pixels by an independent prototype
        Map<SamplingMethod, Double> onLens = Map.of(
                SamplingMethod.RANDOM, -0.50,
                SamplingMethod.JITTERED, -0.75,
                SamplingMethod.ADDITIVE, -0.80,
                SamplingMethod.SOBOL, -0.75,
                SamplingMethod.HALTON, -0.73);
        onLens.forEach((method, slope) ->
                assertThat(slope("edge", method, all)).as(method.title()).isBetween(slope - 0.06, slope + 0.06));
        assertThat(slope("edge-in-pixel", SamplingMethod.SOBOL, all)).isBetween(-0.7, -0.57);
        assertThat(slope("edge-in-pixel", SamplingMethod.JITTERED, all)).isBetween(-0.6, -0.48);
    }

    @Test
    void samplerThatStaysInTheCentreIsFound() {
        Map<String, SamplingMethod.Factory> broken = randomAlone();
        broken.put(PROGRAM, (seed, samples, space) -> (positions, sample) -> {
            for (int i = 0; i < positions.count(); i++) {
                new Position().give(positions, i);
            }
        });
        SamplingStudy study = study(256, broken);
        assertThat(Conclusion.of(study, measure(study)).findings())
                .filteredOn(finding -> !finding.holds())
                .hasSizeGreaterThanOrEqualTo(4);
    }

    /**
     * Neighbouring pixels err independently: the variance of the mean error of pixels that see the same, divided by
     * what it is without any correlation. It is 1 for independent pixels and their number if all err alike.
     */
    @Test
    void pixelsErrIndependently() {
        SamplingMethod.Factory own = SamplingMethod.SOBOL.factory();
        assertThat(correlation(own.sampler(7, 16, SampledSpace.LENS))).isLessThan(2);
        for (IntUnaryOperator[] alike : pixelsThatAreTakenForOne()) {
            Sampler right = own.sampler(7, 16, SampledSpace.LENS);
            assertThat(correlation(taken(right, alike[0], alike[1]))).isGreaterThan(2);
        }
    }

    private static double correlation(Sampler sampler) {
        double[] errors = ExactProblems.ON_LENS.errors(7, sampler, 16);
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
        return ofMeans / ofAll * ExactProblem.PIXELS_OF_INSTANCE;
    }

    /** A sampler that takes several pixels for one. */
    private static Sampler taken(Sampler right, IntUnaryOperator column, IntUnaryOperator row) {
        SamplePositions other = new SamplePositions(1 << 10);
        Position position = new Position();
        return (positions, sample) -> {
            other.clear();
            for (int i = 0; i < positions.count(); i++) {
                other.addPixel(column.applyAsInt(positions.columns[i]), row.applyAsInt(positions.rows[i]));
            }
            right.choose(other, sample);
            for (int i = 0; i < positions.count(); i++) {
                position.goTo(other, i);
                position.give(positions, i);
            }
        };
    }

    /** All pixels, those of a column, those of a row, and pairs of neighbours in both directions. */
    private static List<IntUnaryOperator[]> pixelsThatAreTakenForOne() {
        IntUnaryOperator all = position -> 0;
        IntUnaryOperator none = position -> position;
        IntUnaryOperator pairs = position -> position / 2;
        return List.of(
                new IntUnaryOperator[] {all, all},
                new IntUnaryOperator[] {none, all},
                new IntUnaryOperator[] {all, none},
                new IntUnaryOperator[] {pairs, pairs});
    }

    private static Map<String, SamplingMethod.Factory> randomAlone() {
        Map<String, SamplingMethod.Factory> methods = new LinkedHashMap<>();
        methods.put(SamplingMethod.RANDOM.title(), SamplingMethod.RANDOM.factory());
        return methods;
    }

    private static SamplingStudy study(int mostSamples, Map<String, SamplingMethod.Factory> methods) {
        return new SamplingStudy("aperture", 7, mostSamples, 1, methods, ExactProblems.OF_LENS, Map.of());
    }

    private static List<StudyPoint> measure(Study study) {
        return study.trials().stream().map(Trial::measure).toList();
    }

    private static double slope(String problem, SamplingMethod method, List<StudyPoint> all) {
        return PowerLaw.ofError(
                        all.stream()
                                .filter(point -> point.problem().equals(problem))
                                .filter(point -> point.method().equals(method.title()))
                                .filter(point -> point.setting() >= 16)
                                .toList(),
                        StudyPoint::setting)
                .slope();
    }
}
