package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.Thorough;
import tompkins.camera.PixelSampler;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;

/** The slopes of theory, the exact answers against fine grids, and what happens if a sampler is broken. */
class ExposureStudyTest {

    private static final String PROGRAM = SamplingStudy.PROGRAM;

    @ParameterizedTest
    @MethodSource("problems")
    void exactAnswersAreSumsOverGrids(ExactProblem problem) {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 6; i++) {
            ExactProblem.Instance instance = problem.instances().apply(random);
            assertThat(instance.exact()).as("%s %d", problem.key(), i).isEqualTo(gridMean(instance), within(1e-3));
        }
    }

    static List<ExactProblem> problems() {
        return ExactProblems.OF_EXPOSURE;
    }

    private static double gridMean(ExactProblem.Instance instance) {
        Position position = new Position();
        int side = 20;
        int times = 4000;
        double sum = 0;
        for (int i = 0; i < side * side; i++) {
            position.x = (i % side + 0.5) / side;
            position.y = (i / side + 0.5) / side;
            for (int j = 0; j < times; j++) {
                position.moment = (j + 0.5) / times;
                sum += instance.integrand().applyAsDouble(position);
            }
        }
        return sum / (side * side * times);
    }

    @Test
    void methodsFallAsTheorySays() {
        SamplingStudy study = study(1024, SamplingMethod.all());
        List<StudyPoint> all = measure(study);
        assertThat(Conclusion.of(study, all).findings())
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
    }

    /** As if the moment were still the same for all samples. */
    @Test
    void samplerThatStaysInOneInstantIsFound() {
        Map<String, SamplingMethod.Factory> broken = new LinkedHashMap<>();
        broken.put(SamplingMethod.RANDOM.title(), SamplingMethod.RANDOM.factory());
        broken.put(PROGRAM, (seed, samples, space) -> new PixelSampler(seed, true, false));
        SamplingStudy study = study(256, broken);
        assertThat(Conclusion.of(study, measure(study)).findings())
                .filteredOn(finding -> !finding.holds())
                .hasSizeGreaterThanOrEqualTo(2 * ExactProblems.OF_EXPOSURE.size());
    }

    private static SamplingStudy study(int mostSamples, Map<String, SamplingMethod.Factory> methods) {
        return new SamplingStudy("exposure", 7, mostSamples, 1, methods, ExactProblems.OF_EXPOSURE, Map.of());
    }

    /** What {@code --error} promises, of the scenes with an exposure time or a rolling shutter. */
    @Test
    @Thorough
    void errorIsAsPromisedWithLongExposures() throws IOException {
        Map<String, Studio> exposed = new LinkedHashMap<>();
        for (String name : List.of("long-exposure", "rolling-slit", "rolling-fence")) {
            exposed.put(name, BundledScenes.studio(name + ".json"));
        }

        List<StudyPoint> all = new PromisedErrors(exposed, 1, 40, 256)
                .trials().stream().map(Trial::measure).toList();

        assertThat(all).hasSize(18);
        Conclusion conclusion = new Conclusion();
        PromisedErrors.conclude(all, conclusion);
        assertThat(conclusion.findings())
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
    }

    private static List<StudyPoint> measure(Study study) {
        return study.trials().stream().map(Trial::measure).toList();
    }
}
