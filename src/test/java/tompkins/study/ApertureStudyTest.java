package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntUnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.SamplePositions;
import tompkins.camera.Sampler;

/** The slopes of theory, and what happens if a sampler is broken. */
class ApertureStudyTest {

    private static final String PROGRAM = SamplingStudy.PROGRAM;

    @Test
    void methodsFallAsTheoryAndTableSay() {
        ApertureStudy study = study(1024, SamplingMethod.all(7).methods());
        List<Measurement> all = measure(study);
        assertThat(Conclusion.of(study, all).findings())
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
        // measured for 400 other pixels by an independent prototype
        Map<SamplingMethod, Double> onLens = Map.of(
                SamplingMethod.RANDOM, -0.50,
                SamplingMethod.JITTERED, -0.75,
                SamplingMethod.ADDITIVE, -0.80,
                SamplingMethod.SOBOL, -0.75,
                SamplingMethod.HALTON, -0.73,
                SamplingMethod.VOGEL, -0.77);
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
                positions.choose(i, 0.5, 0.5, 0, 0, 0.5);
            }
        });
        ApertureStudy study = study(256, broken);
        assertThat(Conclusion.of(study, measure(study)).findings())
                .filteredOn(finding -> !finding.holds())
                .hasSizeGreaterThan(4);
    }

    @ParameterizedTest
    @MethodSource("pixelsThatAreTakenForOne")
    void samplerThatIsTheSameInSeveralPixelsIsFound(IntUnaryOperator column, IntUnaryOperator row) {
        Map<String, SamplingMethod.Factory> broken = randomAlone();
        broken.put(PROGRAM, (seed, samples, space) -> {
            Sampler right = SamplingMethod.SOBOL.factory().sampler(seed, samples, space);
            SamplePositions other = new SamplePositions(SamplePattern.PIXELS);
            Position position = new Position();
            return (positions, sample) -> {
                other.clear();
                for (int i = 0; i < positions.count(); i++) {
                    other.addPixel(column.applyAsInt(positions.column(i)), row.applyAsInt(positions.row(i)));
                }
                right.choose(other, sample);
                for (int i = 0; i < positions.count(); i++) {
                    position.goTo(other, i);
                    positions.choose(i, position.x, position.y, position.lensX, position.lensY, position.moment);
                }
            };
        });
        ApertureStudy study = study(64, broken);
        assertThat(Conclusion.of(study, measure(study)).findings())
                .filteredOn(finding -> !finding.holds())
                .anySatisfy(finding -> assertThat(finding.criterion()).contains("err independently"));
    }

    /** All pixels, those of a column, those of a row, and pairs of neighbours in both directions. */
    static Stream<Arguments> pixelsThatAreTakenForOne() {
        IntUnaryOperator all = position -> 0;
        IntUnaryOperator none = position -> position;
        IntUnaryOperator pairs = position -> position / 2;
        return Stream.of(arguments(all, all), arguments(none, all), arguments(all, none), arguments(pairs, pairs));
    }

    private static Map<String, SamplingMethod.Factory> randomAlone() {
        Map<String, SamplingMethod.Factory> methods = new LinkedHashMap<>();
        methods.put(SamplingMethod.RANDOM.title(), SamplingMethod.RANDOM.factory());
        return methods;
    }

    private static ApertureStudy study(int mostSamples, Map<String, SamplingMethod.Factory> methods) {
        return new ApertureStudy(Map.of(), new SamplingStudy.Comparison(7, mostSamples, 1, methods));
    }

    private static List<Measurement> measure(Study study) {
        return study.trials().stream().map(Trial::measure).toList();
    }

    private static double slope(String problem, SamplingMethod method, List<Measurement> all) {
        return PowerLaw.ofError(
                        all.stream()
                                .filter(point -> point.problem().equals(problem))
                                .filter(point -> point.method().equals(method.title()))
                                .filter(point -> point.setting() >= 16)
                                .toList(),
                        Measurement::setting)
                .slope();
    }
}
