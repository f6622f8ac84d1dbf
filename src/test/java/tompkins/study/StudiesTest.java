package tompkins.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import org.assertj.core.api.recursive.comparison.RecursiveComparisonConfiguration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.TestRun;
import tompkins.Thorough;
import tompkins.studio.PaperStudios;
import tompkins.studio.Studio;
import tompkins.study.Conclusion.Finding;

/** The studies find what theory says, keep their figures, and draw them. */
class StudiesTest {

    private static final Study PRECISION = new PrecisionStudy(5);

    /** What was measured, for the tests that ask other things of it. */
    private static final IdentityHashMap<Study, List<StudyPoint>> MEASURED = new IdentityHashMap<>();

    @TempDir
    private Path folder;

    @ParameterizedTest
    @MethodSource("studies")
    void findingsHold(Study study) {
        List<StudyPoint> all = measure(study);
        assertThat(Conclusion.of(study, all).findings())
                .isNotEmpty()
                .allSatisfy(finding ->
                        assertThat(finding.holds()).as(finding.sentence()).isTrue());
        for (Chart chart : study.charts()) {
            assertThat(chart.drawn(all)).as(chart.title()).isNotEmpty();
            assertThat(ChartDrawing.png(chart, all)).hasSizeLessThan(100_000);
            ChartDrawingTest.assertReadable(chart, all);
        }
    }

    static List<Study> studies() {
        List<Study> studies = new ArrayList<>(List.of(PRECISION, new DepthStudy(), new StabilityStudy(3)));
        if (TestRun.THOROUGH) {
            Map<String, Studio> figure = Map.of("fig1b", PaperStudios.fig1b());
            PromisedErrors promises = new PromisedErrors(figure, 3, 24, 256);
            studies.add(new AntialiasingStudy(figure, promises, 3, 72, 1024));
        }
        return studies;
    }

    /** Triangles that are thinner than the way between a curve and its chord. */
    @Test
    @Thorough
    void moreChordsOfACurveMissFewerSlivers() {
        List<Double> missed = new ChordStudy(5)
                .trials().stream()
                        .filter(trial -> trial.method().equals("slivers"))
                        .map(trial -> trial.measure().medianError())
                        .toList();
        assertThat(missed).hasSize(5).isSortedAccordingTo(Comparator.reverseOrder());
        assertThat(missed.get(0)).isGreaterThan(10 * missed.get(4));
    }

    /** The powers of gamma of the theory: rounding of nearly equal numbers costs gamma twice, half angles once. */
    @Test
    void precisionIsLostAsTheorySays() {
        List<StudyPoint> all = measure(PRECISION);
        Map<DirectionForm, Double> inTheScene =
                Map.of(DirectionForm.PROPER_VELOCITY, 2.0, DirectionForm.HALF_ANGLE, 1.0);
        inTheScene.forEach((form, power) -> {
            assertThat(PrecisionStudy.law(PrecisionStudy.RADIANS, form, all).slope())
                    .as("%s in radians", form)
                    .isEqualTo(power, within(0.1));
            assertThat(PrecisionStudy.law(PrecisionStudy.PIXELS, form, all).slope())
                    .as("%s in pixels", form)
                    .isEqualTo(1, within(0.1));
        });
    }

    @Test
    void brokenPromisesAreFound() {
        assertThat(promises(promised(96, 4, 0.0001))).allMatch(Finding::holds);
        assertThat(promises(promised(94, 6, 0.0001)).get(0).holds()).isFalse();
    }

    private static List<Finding> promises(List<StudyPoint> all) {
        Conclusion conclusion = new Conclusion();
        PromisedErrors.conclude(all, conclusion);
        return conclusion.findings();
    }

    @Test
    void referencesThatAreNotGoodEnoughAreFound() {
        List<Finding> findings = promises(promised(100, 0, 0.0011));
        assertThat(findings.get(1).holds()).isFalse();
    }

    /** Runs that err as promised, and runs that err by 1.3 times as much. */
    private static List<StudyPoint> promised(int kept, int broken, double floor) {
        List<StudyPoint> runs = new ArrayList<>();
        for (int run = 0; run < kept + broken; run++) {
            double error = 0.01 * (run < kept ? 1 : 1.3);
            String problem = "promise:scene:seed " + run;
            runs.add(new StudyPoint(problem, "pinholes", 0.01, 1, Spread.exact(1), Spread.exact(error), error, floor));
        }
        return runs;
    }

    @Test
    void figuresAreReadAsTheyWereWritten() throws IOException {
        Path file = folder.resolve("precision.csv");
        StudyData.Origin origin = StudyData.Origin.here(StudyKind.PRECISION, PRECISION, "Tompkins 0.1");
        StudyData data = new StudyData(origin, measure(PRECISION));
        data.write(file);

        StudyData read = StudyData.read(file).orElseThrow();

        assertThat(read.origin()).isEqualTo(origin);
        assertThat(read.measurements()).hasSameSizeAs(data.measurements());
        assertThat(read.measurements())
                .usingRecursiveFieldByFieldElementComparator(RecursiveComparisonConfiguration.builder()
                        .withComparatorForType(StudiesTest::roughly, Double.class)
                        .build())
                .isEqualTo(data.measurements());
        Files.writeString(file, "my own notes\n");
        assertThat(StudyData.read(file)).isEmpty();
    }

    /** Six digits are kept. */
    private static int roughly(double one, double other) {
        return Math.abs(one - other) <= 1e-5 * Math.abs(one) ? 0 : Double.compare(one, other);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3})
    void pictureThatNobodyWaitsForIsMeasuredNoMore(int wanted) {
        List<StudyPoint> shown = new ArrayList<>();
        PictureStudy study = new PictureStudy("picture", PaperStudios.fig1b(), 1, 80, 64, () -> shown.size() == wanted);

        assertThatThrownBy(() -> study.measure(points -> shown.add(points.get(points.size() - 1))))
                .isInstanceOf(CancellationException.class);

        assertThat(shown).hasSize(wanted);
        assertThat(study.trials(false).size()).isGreaterThan(3);
    }

    @Test
    void lawIsFitted() {
        double[] x = {1, 4, 16, 64, 256};
        double[] y = {3, 1.5, 0.75, 0.375, 0.1875};
        PowerLaw law = PowerLaw.fit(x, y);
        assertThat(law.slope()).isEqualTo(-0.5, within(1e-12));
        assertThat(law.factor()).isEqualTo(3, within(1e-12));
        assertThat(law.rSquared()).isEqualTo(1, within(1e-12));
        assertThat(PowerLaw.fit(x, new double[] {1, 2, 1, 2, 1}).rSquared()).isLessThan(0.1);
    }

    @Test
    void frontHoldsWhatNoOtherBeats() {
        Chart chart = Chart.errorAgainstTime("p", "title", "");
        StudyPoint cheap = point(1, 0.5);
        StudyPoint beaten = point(2, 0.6);
        StudyPoint good = point(3, 0.1);
        StudyPoint asDear = point(3, 0.2);
        assertThat(ChartDrawing.front(chart, List.of(asDear, good, beaten, cheap)))
                .containsExactly(cheap, good);
    }

    private static StudyPoint point(double seconds, double error) {
        return new StudyPoint("p", "m", 1, 1, Spread.exact(seconds), Spread.exact(error), error, 0);
    }

    private static List<StudyPoint> measure(Study study) {
        return MEASURED.computeIfAbsent(
                study, first -> first.trials().stream().map(Trial::measure).toList());
    }
}
