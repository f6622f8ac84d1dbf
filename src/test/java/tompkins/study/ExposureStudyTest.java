package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.io.BundledScenes;
import tompkins.studio.Studio;

/** The slopes of theory, the exact answers against fine grids, and what happens if a sampler is broken. */
class ExposureStudyTest {

    private static final String PROGRAM = SamplingMethod.SOBOL.title();

    @ParameterizedTest
    @EnumSource
    void exactAnswersAreSumsOverGrids(MotionProblem problem) {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 6; i++) {
            ExactProblem.Instance instance = problem.instance(random);
            assertThat(instance.exact()).as("%s %d", problem, i).isEqualTo(gridMean(instance), within(1e-3));
        }
    }

    private static double gridMean(ExactProblem.Instance instance) {
        RandomPattern place = new RandomPattern(1, SampledSpace.TIME_AND_PIXEL);
        int side = 20;
        int times = 4000;
        double sum = 0;
        for (int i = 0; i < side * side; i++) {
            place.x = (i % side + 0.5) / side;
            place.y = (i / side + 0.5) / side;
            for (int j = 0; j < times; j++) {
                place.moment = (j + 0.5) / times;
                sum += instance.integrand().value(place);
            }
        }
        return sum / (side * side * times);
    }

    @Test
    void methodsFallAsTheorySays() {
        ExposureStudy study = study(SamplingMethod.inTime());
        List<Measurement> all = measure(study);
        assertThat(study.findings(all))
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
    }

    /** As if the moment were still the same for all samples. */
    @Test
    void samplerThatStaysInOneInstantIsFound() {
        Map<String, SamplingMethod.Factory> broken = new LinkedHashMap<>();
        broken.put(SamplingMethod.RANDOM.title(), SamplingMethod.RANDOM.factory());
        broken.put(PROGRAM, (seed, samples, space) -> new ProgramPattern(seed, SampledSpace.LENS_AND_PIXEL));
        ExposureStudy study = study(broken);
        assertThat(study.findings(measure(study)))
                .filteredOn(finding -> !finding.holds())
                .hasSizeGreaterThanOrEqualTo(2 * MotionProblem.values().length);
    }

    private static ExposureStudy study(Map<String, SamplingMethod.Factory> methods) {
        return new ExposureStudy(Map.of(), 7, 1024, 1, methods, PROGRAM);
    }

    /** What {@code --error} promises, of the scenes with an exposure time or a rolling shutter. */
    @Test
    @Tag("slow")
    void errorIsAsPromisedWithLongExposures() throws IOException {
        Map<String, Studio> exposed = new LinkedHashMap<>();
        for (String name : List.of("long-exposure", "rolling-slit", "rolling-fence")) {
            exposed.put(name, BundledScenes.studio(name + ".json"));
        }

        List<Measurement> all = new PromisedErrors(exposed, 1, 40, 256)
                .trials().stream().map(Trial::measure).toList();

        assertThat(all).hasSize(27);
        assertThat(PromisedErrors.findings(all))
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
    }

    private static List<Measurement> measure(Study study) {
        return study.trials().stream().map(Trial::measure).toList();
    }
}
