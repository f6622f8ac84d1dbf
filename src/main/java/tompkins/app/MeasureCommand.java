package tompkins.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.io.FactCsv;
import tompkins.io.FactJson;
import tompkins.io.FactText;
import tompkins.io.StudioReader;
import tompkins.lesson.LessonNumber;
import tompkins.measure.Fact;
import tompkins.measure.LessonResult;
import tompkins.measure.LessonStudio;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Measurements;
import tompkins.measure.RayTable;
import tompkins.measure.Sketch;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Measures in the picture of a scene. */
@Command(
        header = "Measures angles, distances and times between pixels.",
        description = "\"between\" gives angles, distances, times and the"
                + " interval between two pixels, in the frames of scene, camera and object; \"circle\" fits a circle of"
                + " directions, such as the outline of a sphere, to three pixels or more; \"line\" says how straight two"
                + " pixels or more lie; \"profile\" follows the line between two pixels. \"lesson\" measures the numbers of the"
                + " scene's lesson and compares them with its formulas.")
final class MeasureCommand extends ProgramCommand {

    private static final String LESSON = "lesson";

    @Parameters(index = "0", paramLabel = "WHAT", description = "between, profile, circle, line or lesson")
    private String what;

    @Parameters(
            index = "1",
            paramLabel = "SCENE",
            description = "scene file, or saved photograph; - is the standard input")
    private Path scene;

    @Option(
            names = "--pixel",
            paramLabel = "X,Y",
            description = "column and row of a pixel, from 0 at the upper left; whole numbers are centres, and 3.5 lies"
                    + " on the edge between 3 and 4")
    private List<String> pixels = new ArrayList<>();

    @Mixin
    private TextOutput output;

    @Mixin
    private SceneOptions options;

    @Override
    public Integer call() throws IOException {
        boolean isLesson = what.equals(LESSON);
        MeasureKind kind = isLesson ? null : kind();
        Studio studio = options.read(scene, List.of());
        requireOptions(kind, studio.settings());
        output.check(studio, scene);
        output.write(out(), isLesson ? lesson(studio) : lines(measure(kind, planned(studio))));
        return 0;
    }

    private MeasureKind kind() {
        return MeasureKind.named(what)
                .orElseThrow(() -> new MistakeException(
                        "WHAT must be one of between, profile, circle, line, lesson; was " + OptionValues.shown(what)));
    }

    /** Checks that there are as many pixels as a kind needs; a lesson, which has no kind, needs none. */
    private void requireOptions(MeasureKind kind, RenderSettings settings) {
        pixels.forEach(pixel -> point(pixel, settings));
        if (kind == null && !pixels.isEmpty()) {
            throw new MistakeException("--pixel is for what is measured between pixels; leave it out of " + what);
        }
        if (kind != null && (pixels.size() < kind.fewest() || pixels.size() > kind.most())) {
            throw new MistakeException(kind + " needs " + kind.fewest()
                    + (kind.most() == kind.fewest() ? "" : " or more") + " --pixel, was " + pixels.size());
        }
    }

    private static Vector2dc point(String pixel, RenderSettings settings) {
        double[] numbers = OptionValues.numbers("--pixel", pixel, "320,240");
        double right = settings.width() - 0.5;
        double bottom = settings.height() - 0.5;
        if (!(numbers[0] >= -0.5 && numbers[1] >= -0.5 && numbers[0] <= right && numbers[1] <= bottom)) {
            throw new MistakeException("--pixel must lie in the picture, from -0.5,-0.5 to " + NumberText.of(right)
                    + "," + NumberText.of(bottom) + ", was " + pixel);
        }
        return new Vector2d(numbers[0] + 0.5, numbers[1] + 0.5);
    }

    private Measured measure(MeasureKind kind, RenderPlan plan) {
        List<Vector2dc> points = pixels.stream()
                .map(pixel -> point(pixel, plan.studio().settings()))
                .toList();
        try {
            return Measurements.measure(plan, kind, points, () -> true);
        } catch (ArithmeticException noFit) {
            throw new MistakeException("--pixel: " + noFit.getMessage());
        }
    }

    /** The plan of what is measured, after its warnings are told. */
    private RenderPlan planned(Studio studio) {
        RenderPlan plan = ScenePlan.of(studio, scene);
        ScenePlan.warn(ScenePlan.warnings(plan), err());
        return plan;
    }

    /** What was measured; of a profile the rays. */
    private Stream<String> lines(Measured measured) {
        if (measured.profile() != null) {
            return table(
                    RayTable.headings(),
                    measured.profile().stream().map(RayTable::row).toList());
        }
        if (output.isJson()) {
            return Stream.of(FactJson.measured(measured.facts()));
        }
        return output.isCsv()
                ? FactCsv.quantities(measured.facts())
                : FactText.LETTERS.lines(measured.facts()).map(FactText.Line::toString);
    }

    /** What the numbers of a lesson are in its picture, and by its formulas. */
    private Stream<String> lesson(Studio studio) {
        LessonStudio lesson = ScenePlan.lesson(studio, scene);
        planned(lesson.measured());
        List<LessonResult> results = StudioReader.used(scene, lesson::results);
        List<Fact> headings = new LessonResult(LessonNumber.DEFAULT, 0, Sketch.EMPTY).facts();
        return table(headings, results.stream().map(LessonResult::facts).toList());
    }

    private Stream<String> table(List<Fact> headings, List<List<Fact>> rows) {
        if (output.isJson()) {
            return FactJson.list(rows.stream().map(FactJson::values));
        }
        return output.isCsv() ? FactCsv.table(headings, rows.stream()) : FactText.EXACT.table(headings, rows);
    }
}
