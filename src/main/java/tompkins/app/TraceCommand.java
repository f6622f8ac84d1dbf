package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.joml.Vector3dc;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.io.CsvText;
import tompkins.io.RayLifeWriter;
import tompkins.io.StudioReader;
import tompkins.measure.Sighting;
import tompkins.property.NumberText;
import tompkins.property.OneLine;
import tompkins.property.Require;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** Shows the lives of rays. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description =
                "Shows the life of a ray: its events and directions in both frames, its hits, its colour. Hits on what"
                        + " moves by itself are also given in its own frame, with its proper time. Where"
                        + " a ray splits, as in glass, all hits of the weaker branch come first, indented; entry and frequency are those of"
                        + " the main branch. The share is the most light of the pixel that the ray of a hit can still add."
                        + " Several --pixel show several rays, each under its pixel, with --json in one list, with --csv in one table.")
final class TraceCommand implements Callable<Integer>, SceneCommand {

    /** Half of the way from the centre of the lens to its right edge. */
    private static final String PUPIL_EXAMPLE = "0.5,0";

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph")
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

    @ArgGroup
    private Form form = new Form();

    @Mixin
    private TextOutput output;

    @Mixin
    private StudioOptions options;

    @Spec
    private CommandSpec spec;

    /** How rays are told, if not in words. */
    private static final class Form {

        @Option(
                names = "--json",
                description =
                        "print JSON with 17 significant digits; null for a ray that never crosses the shutter, and for a number"
                                + " that is not finite; no \"scene\" for a ray that never enters the scene frame")
        private boolean json;

        @Option(
                names = "--csv",
                description = "print a table with a row for each pixel: events, directions, what was hit, times and"
                        + " colour, with 17 significant digits; empty where a ray has no such number")
        private boolean csv;
    }

    @Override
    public Path scene() {
        return scene;
    }

    @Override
    public Integer call() throws IOException {
        double[] lens = StudioOptions.numbers("--pupil", pupil, PUPIL_EXAMPLE);
        Studio studio = options.applyTo(StudioReader.read(scene));
        PixelChoice places = PixelChoice.of(pixels, every, studio.settings());
        if (Math.hypot(lens[0], lens[1]) > 1) {
            throw new MistakeException(
                    "--pupil must lie in the unit disc, such as --pupil=" + PUPIL_EXAMPLE + ", was " + pupil);
        }
        MistakeException.inOption("--moment", () -> Require.within("moment", moment, 0.0, 1.0));
        output.check();
        RenderPlan plan = ScenePlan.of(studio, scene);
        Stream<Sighting> sightings = places.stream().map(place -> follow(plan, place[0], place[1], lens));
        output.write(spec.commandLine().getOut(), lines(sightings, places.isSingle()));
        return 0;
    }

    private Sighting follow(RenderPlan plan, int column, int row, double[] lens) {
        double x = column + 0.5;
        double y = row + 0.5;
        return new Sighting(plan.studio(), x, y, RayLife.of(plan, x, y, lens[0], lens[1], moment));
    }

    private Stream<String> lines(Stream<Sighting> sightings, boolean single) {
        if (form.csv) {
            return Stream.concat(Stream.of(CsvText.rayHeadings()), sightings.map(CsvText::rayRow));
        }
        if (form.json) {
            return single ? sightings.map(TraceCommand::json) : list(sightings.map(TraceCommand::json));
        }
        return single
                ? sightings.map(TraceCommand::text)
                : apart(sightings.map(sighting ->
                        format("Pixel %d, %d%n", (int) Math.floor(sighting.x()), (int) Math.floor(sighting.y()))
                                + text(sighting)));
    }

    /** A list in brackets, each part but the last with a comma behind it; a part is made when it is asked for. */
    private static Stream<String> list(Stream<String> parts) {
        Iterator<String> each = parts.iterator();
        return Stream.iterate(
                "[" + each.next() + (each.hasNext() ? "," : "]"),
                Objects::nonNull,
                before -> each.hasNext() ? each.next() + (each.hasNext() ? "," : "]") : null);
    }

    /** With an empty line before each but the first. */
    private static Stream<String> apart(Stream<String> parts) {
        boolean[] begun = new boolean[1];
        return parts.sequential().map(part -> {
            String before = begun[0] ? System.lineSeparator() : "";
            begun[0] = true;
            return before + part;
        });
    }

    private static String text(Sighting sighting) {
        StringWriter text = new StringWriter();
        try (PrintWriter out = new PrintWriter(text)) {
            print(out, sighting.life(), sighting.studio());
        }
        return text.toString().stripTrailing();
    }

    private static String json(Sighting sighting) {
        return sighting.life() == null ? "null" : RayLifeWriter.json(sighting.life(), sighting.studio());
    }

    private static void print(PrintWriter out, RayLife life, Studio studio) {
        if (life == null) {
            out.println("This ray never crosses the shutter: it brings no light and has no events.");
            return;
        }
        out.println("Camera frame");
        printStart(out, life.cameraStart(), life.cameraDirection());
        if (life.sceneStart() != null) {
            out.println("Scene frame");
            printStart(out, life.sceneStart(), life.sceneDirection());
        }
        out.println("frequency ratio (camera/scene)  "
                + (studio.view() == View.MEASURED
                        ? "none: measured at one time of the camera, without light"
                        : format("%.12g", life.frequencyRatio())));
        SpeedScale scale = studio.transformation().speedScale();
        out.println(format("%-30s  %.12g", scale.key(), scale.valueOf(studio.velocity())));
        life.hits().forEach(hit -> print(out, hit, studio));
        if (life.hits().isEmpty()) {
            out.println(
                    life.reachesBackground()
                            ? "hits nothing: the background"
                            : "stands still in the scene: it comes from nowhere and brings no light");
        }
        out.println(format(
                "colour (linear)  %.9g, %.9g, %.9g",
                life.colour().red(), life.colour().green(), life.colour().blue()));
    }

    /** A hit in its own frame, then in those that differ from it: that of the camera or the scene, and the object's. */
    private static void print(PrintWriter out, RayLife.Encounter hit, Studio studio) {
        String indent = "  ".repeat(hit.branch());
        out.println(format(
                "%shit  %s (%s) in the %s frame at %s, distance %.9g, share %s",
                indent,
                OneLine.of(hit.object().description()),
                hit.surface().getClass().getSimpleName(),
                hit.frame().name().toLowerCase(Locale.ROOT),
                text(hit.event()),
                hit.distance(),
                NumberText.plain(hit.share(), 4)));
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        if (!(sceneFromCamera instanceof IdentityTransformation)) {
            out.println(indent
                    + (hit.frame() == Frame.SCENE
                            ? "     in the camera frame at " + text(hit.inCamera(sceneFromCamera))
                            : "     in the scene frame at " + text(hit.inScene(sceneFromCamera))));
        }
        if (hit.movesByItself()) {
            RayLife.Rest own = hit.rest();
            out.println(format(
                    "%s     in its own frame at %s, proper time %.9g, its clocks show %.9g%s",
                    indent,
                    text(own.event().position()),
                    own.event().time(),
                    own.clockReading(),
                    Double.isNaN(own.dopplerFactor())
                            ? ""
                            : format(", frequency ratio (camera/own) %.9g", own.dopplerFactor())));
        }
    }

    private static void printStart(PrintWriter out, Event event, Vector3dc direction) {
        out.println("  position   " + text(event.position()));
        out.println(format("  time       %.12g", event.time()));
        out.println("  direction  " + text(direction));
    }

    private static String text(Event event) {
        return text(event.position()) + format(", t = %.9g", event.time());
    }

    private static String text(Vector3dc vector) {
        return format("(%.9g, %.9g, %.9g)", vector.x(), vector.y(), vector.z());
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
