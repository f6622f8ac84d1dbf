package tompkins.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.io.CsvText;
import tompkins.io.MeasureWriter;
import tompkins.io.StudioReader;
import tompkins.measure.MeasureKind;
import tompkins.measure.Measured;
import tompkins.measure.Measurements;
import tompkins.measure.Profile;
import tompkins.measure.Quantity;
import tompkins.measure.RayTable;
import tompkins.measure.Sighting;
import tompkins.property.NumberText;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Measures in the picture of a scene. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description =
                "Measures in the picture of a scene, between pixels. \"between\" gives angles, distances, times and the"
                        + " interval between two pixels, in the frames of scene, camera and object; \"circle\" fits a circle of"
                        + " directions, such as the outline of a sphere, to three pixels or more; \"conic\" fits an ellipse, a parabola or a"
                        + " hyperbola to five pixels or more; \"line\" says how straight two"
                        + " pixels or more lie; \"profile\" follows the line between two pixels.")
final class MeasureCommand implements Callable<Integer>, SceneCommand {

    @Parameters(index = "0", paramLabel = "WHAT", description = "between, profile, circle, conic or line")
    private String what;

    @Parameters(index = "1", paramLabel = "SCENE", description = "scene file, or saved photograph")
    private Path scene;

    @Option(
            names = "--pixel",
            required = true,
            paramLabel = "X,Y",
            description = "column and row of a pixel, from 0 at the upper left; whole numbers are centres, and 3.5 lies"
                    + " on the edge between 3 and 4")
    private List<String> pixels;

    @Option(
            names = "--count",
            paramLabel = "N",
            description = "number of places of a profile, 2 to 10000; default: one for each pixel on its way")
    private Long count;

    @ArgGroup
    private Form form = new Form();

    @Mixin
    private TextOutput output;

    @Mixin
    private StudioOptions options;

    @Spec
    private CommandSpec spec;

    /** How results are told, if not in words. */
    private static final class Form {

        @Option(names = "--json", description = "print JSON with 17 significant digits")
        private boolean json;

        @Option(names = "--csv", description = "print a table with 17 significant digits")
        private boolean csv;
    }

    @Override
    public Path scene() {
        return scene;
    }

    @Override
    public Integer call() throws IOException {
        MeasureKind kind = kind();
        Studio studio = options.applyTo(StudioReader.read(scene));
        List<Vector2dc> places = new ArrayList<>();
        pixels.forEach(pixel -> places.add(place(pixel, studio.settings())));
        if (places.size() < kind.fewest() || places.size() > kind.most()) {
            throw new MistakeException(kind + " needs " + kind.fewest()
                    + (kind.most() == kind.fewest() ? "" : " or more") + " --pixel, was " + places.size());
        }
        requireCount(kind);
        output.check();
        RenderPlan plan = ScenePlan.of(studio, scene);
        Measured measured = measure(kind, plan, places);
        output.write(
                spec.commandLine().getOut(), kind == MeasureKind.PROFILE ? lines(measured.profile()) : lines(measured));
        return 0;
    }

    private MeasureKind kind() {
        return Arrays.stream(MeasureKind.values())
                .filter(kind -> kind.toString().equals(what))
                .findFirst()
                .orElseThrow(() ->
                        new MistakeException("WHAT must be one of between, profile, circle, conic, line; was " + what));
    }

    private void requireCount(MeasureKind kind) {
        if (count != null && kind != MeasureKind.PROFILE) {
            throw new MistakeException("--count is for a profile; leave it out of " + kind);
        }
        if (count != null && (count < 2 || count > Profile.MOST)) {
            throw new MistakeException("--count must be from 2 to " + Profile.MOST + ", was " + count);
        }
    }

    private static Vector2dc place(String pixel, RenderSettings settings) {
        double[] numbers = StudioOptions.numbers("--pixel", pixel, "320,240");
        double right = settings.width() - 0.5;
        double bottom = settings.height() - 0.5;
        if (!(numbers[0] >= -0.5 && numbers[1] >= -0.5 && numbers[0] <= right && numbers[1] <= bottom)) {
            throw new MistakeException("--pixel must lie in the picture, from -0.5,-0.5 to " + NumberText.of(right)
                    + "," + NumberText.of(bottom) + ", was " + pixel);
        }
        return new Vector2d(numbers[0] + 0.5, numbers[1] + 0.5);
    }

    private Measured measure(MeasureKind kind, RenderPlan plan, List<Vector2dc> places) {
        Vector2dc first = places.get(0);
        Vector2dc second = places.get(1);
        int number = count == null ? Profile.count(first.x(), first.y(), second.x(), second.y()) : count.intValue();
        try {
            return new Measurements(plan).measure(kind, places, number, () -> true);
        } catch (ArithmeticException noFit) {
            throw new MistakeException("--pixel: " + noFit.getMessage());
        }
    }

    private Stream<String> lines(Profile profile) {
        if (form.json) {
            return Stream.of(MeasureWriter.jsonTable(profile.places()));
        }
        if (form.csv) {
            return Stream.concat(
                    Stream.of(CsvText.rayHeadings()), profile.places().stream().map(CsvText::rayRow));
        }
        String heading = "place, object, D, scene time, red, green, blue";
        return Stream.concat(Stream.of(heading), profile.places().stream().map(MeasureCommand::words));
    }

    private static String words(Sighting sighting) {
        List<String> words = new ArrayList<>();
        words.add(number(sighting.x() - 0.5) + "," + number(sighting.y() - 0.5));
        for (String name : List.of("object", "doppler_factor", "hit_scene_time", "red", "green", "blue")) {
            Object value = RayTable.column(name).value().apply(sighting);
            words.add(value instanceof Double number ? number(number) : value == null ? "-" : CsvText.cell(value));
        }
        return String.join("  ", words);
    }

    private Stream<String> lines(Measured measured) {
        if (form.json) {
            return Stream.of(MeasureWriter.json(measured));
        }
        if (form.csv) {
            return CsvText.quantities(measured);
        }
        Stream<String> numbers = measured.quantities().stream().map(MeasureCommand::words);
        return measured.shape() == null
                ? numbers
                : Stream.concat(Stream.of(line("shape", measured.shape().toString())), numbers);
    }

    private static String words(Quantity quantity) {
        String uncertainty = Double.isNaN(quantity.uncertainty())
                ? ""
                : " +- " + NumberText.of(NumberText.rounded(quantity.uncertainty(), 2));
        String unit = quantity.unit().isEmpty() ? "" : " " + quantity.unit();
        return line(quantity.words(), number(quantity.value()) + uncertainty + unit);
    }

    private static String line(String name, String value) {
        return String.format(Locale.ROOT, "%-24s  %s", name, value);
    }

    private static String number(double value) {
        return Double.isFinite(value) ? NumberText.of(NumberText.rounded(value, 9)) : "-";
    }
}
