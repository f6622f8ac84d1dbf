package tompkins.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.io.FactCsv;
import tompkins.io.FactJson;
import tompkins.io.FactText;
import tompkins.measure.RayHistory;
import tompkins.measure.RayTable;
import tompkins.measure.RayTubes;
import tompkins.measure.Sighting;
import tompkins.property.MistakeException;
import tompkins.property.Require;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** Traces rays and tells their histories. */
@Command(
        header = "Traces rays of pixels: their events, hits and colours.",
        description =
                "Events and directions are given in both frames. Hits on moving objects"
                        + " are also given in the rest frame of the object, with its proper time. Where a ray splits, as in glass,"
                        + " all hits of the weaker branch come first, indented; entry and Doppler factor are those of the main"
                        + " branch. The throughput is the largest fraction of the pixel's light that this branch can still add"
                        + " (\"share\" in JSON; 1 is left out of the text)."
                        + " Each hit tells when the light of each lamp that flashes left it, by its own time, and whether the lamp was on."
                        + " Several --pixel show several rays, each under its pixel, with --json in one list, with --csv in one table.")
final class TraceCommand extends ProgramCommand {

    /** Half of the way from the centre of the lens to its right edge. */
    private static final String PUPIL_EXAMPLE = "0.5,0";

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph; - is the standard input")
    private Path scene;

    @Option(
            names = "--pixel",
            required = true,
            paramLabel = "X,Y",
            description = "column and row of the pixel, from 0 at the upper left; its centre is taken. X,Y..X,Y is a"
                    + " rectangle between two pixels, and \"all\" the whole picture")
    private List<String> pixels;

    @Option(
            names = "--pupil",
            defaultValue = "0,0",
            paramLabel = "X,Y",
            description = "point of the lens in units of its radius, to the right and up; default: its centre")
    private String pupil;

    @Option(
            names = "--moment",
            defaultValue = "0.5",
            paramLabel = "M",
            description = "part of the exposure time that has passed, 0 to 1; default: its middle")
    private double moment;

    @Option(
            names = "--every",
            defaultValue = "1",
            paramLabel = "N",
            description = "take each N-th column and row of a rectangle; default: all")
    private long every;

    @Option(
            names = "--draw",
            paramLabel = "SCENE",
            description =
                    "also write a scene file in which the rays are objects: a rod for each straight piece in the scene"
                            + " frame, a ball at each hit")
    private Path drawn;

    @Mixin
    private TextOutput output;

    @Mixin
    private SceneOptions options;

    @Override
    public Integer call() throws IOException {
        double[] lens = OptionValues.numbers("--pupil", pupil, PUPIL_EXAMPLE);
        Studio studio = options.read(scene, List.of());
        PixelChoice choice = PixelChoice.of(pixels, every, studio.settings());
        if (Math.hypot(lens[0], lens[1]) > 1) {
            throw new MistakeException(
                    "--pupil must lie in the unit disc, such as --pupil=" + PUPIL_EXAMPLE + ", was " + pupil);
        }
        MistakeException.inOption("--moment", () -> Require.within("moment", moment, 0.0, 1.0));
        output.check(studio, scene);
        if (drawn != null) {
            NamedFile.requireEnding(drawn, "scene", ".json");
            output.check(drawn, studio, scene);
        }
        RenderPlan plan = ScenePlan.of(studio, scene);
        ScenePlan.warn(ScenePlan.warnings(plan), err());
        if (drawn != null) {
            draw(plan, choice, lens);
        }
        Stream<Sighting> sightings = choice.stream().map(place -> follow(plan, place[0], place[1], lens));
        output.write(out(), lines(sightings, choice.isSingle()));
        return 0;
    }

    private void draw(RenderPlan plan, PixelChoice choice, double[] lens) throws IOException {
        List<SampleHistory> rays = choice.stream()
                .flatMap(place ->
                        Stream.ofNullable(follow(plan, place[0], place[1], lens).life()))
                .toList();
        if (!RayTubes.canDraw(rays)) {
            throw new MistakeException("--draw: none of these rays enters the scene");
        }
        String name = rays.size() == 1 ? "ray of pixel " + pixels.get(0) : rays.size() + " rays";
        output.save(RayTubes.addedTo(plan.studio(), name, rays), drawn);
    }

    private Sighting follow(RenderPlan plan, int column, int row, double[] lens) {
        double x = column + 0.5;
        double y = row + 0.5;
        return new Sighting(plan.studio(), x, y, SampleHistory.of(plan, x, y, lens[0], lens[1], moment));
    }

    private Stream<String> lines(Stream<Sighting> sightings, boolean single) {
        if (output.isCsv()) {
            return FactCsv.table(RayTable.headings(), sightings.map(RayTable::row));
        }
        if (output.isJson()) {
            Stream<String> values = sightings.map(sighting -> FactJson.values(RayHistory.of(sighting)));
            return single ? values : FactJson.list(values);
        }
        return single
                ? sightings.flatMap(TraceCommand::history)
                : sightings
                        .flatMap(sighting -> Stream.concat(Stream.of("", title(sighting)), history(sighting)))
                        .skip(1);
    }

    private static String title(Sighting sighting) {
        return "Pixel " + (int) Math.floor(sighting.x()) + ", " + (int) Math.floor(sighting.y());
    }

    private static Stream<String> history(Sighting sighting) {
        return FactText.EXACT.lines(RayHistory.of(sighting)).map(FactText.Line::toString);
    }
}
