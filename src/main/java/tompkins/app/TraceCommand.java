package tompkins.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.joml.Vector3dc;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.io.RayLifeWriter;
import tompkins.io.StudioReader;
import tompkins.property.NumberText;
import tompkins.property.OneLine;
import tompkins.property.Require;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.Frame;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** Shows the lives of rays. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description = "Shows the life of a ray: its events and directions in both frames, its hits, its colour. Of what"
                + " moves by itself, hits are told in its own frame, too, with its proper time. Where"
                + " a ray splits, as in glass, all hits of the weaker branch come first, indented; entry and frequency are those of"
                + " the main branch. The share is the most light of the pixel that the ray of a hit can still add."
                + " Several --pixel show several rays, each under its pixel, with --json in one list.")
final class TraceCommand implements Callable<Integer>, SceneCommand {

    /** Half of the way from the centre of the lens to its right edge. */
    private static final String PUPIL_EXAMPLE = "0.5,0";

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph")
    private Path scene;

    @Option(
            names = "--pixel",
            required = true,
            paramLabel = "X,Y",
            description = "column and row of the pixel, from 0 at the upper left; its centre is taken")
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
            names = "--json",
            description =
                    "print JSON with 17 significant digits; null for a ray that never crosses the shutter, and for a number"
                            + " that is not finite; no \"scene\" for a ray that never enters the scene frame")
    private boolean json;

    @Mixin
    private StudioOptions options;

    @Spec
    private CommandSpec spec;

    @Override
    public Path scene() {
        return scene;
    }

    @Override
    public Integer call() {
        List<int[]> places = pixels.stream().map(TraceCommand::place).toList();
        double[] lens = StudioOptions.numbers("--pupil", pupil, PUPIL_EXAMPLE);
        Studio studio = options.applyTo(StudioReader.read(scene));
        places.forEach(place -> requireInside(place, studio.settings()));
        if (Math.hypot(lens[0], lens[1]) > 1) {
            throw new MistakeException(
                    "--pupil must lie in the unit disc, such as --pupil=" + PUPIL_EXAMPLE + ", was " + pupil);
        }
        double checkedMoment = MistakeException.inOption("--moment", () -> Require.within("moment", moment, 0.0, 1.0));
        RenderPlan plan = ScenePlan.of(studio, scene);
        List<RayLife> lives = new ArrayList<>();
        for (int[] place : places) {
            // null for a ray without events
            lives.add(RayLife.of(plan, place[0] + 0.5, place[1] + 0.5, lens[0], lens[1], checkedMoment));
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            String list = lives.stream().map(life -> json(life, studio)).collect(Collectors.joining(",\n"));
            out.println(lives.size() == 1 ? list : "[" + list + "]");
        } else {
            for (int i = 0; i < lives.size(); i++) {
                if (lives.size() > 1) {
                    out.println(format("%sPixel %d, %d", i == 0 ? "" : "\n", places.get(i)[0], places.get(i)[1]));
                }
                print(out, lives.get(i), studio);
            }
        }
        return 0;
    }

    private static int[] place(String pixel) {
        return StudioOptions.pair(
                pixel, ",", "--pixel must be two whole numbers inside the picture with a comma between them");
    }

    private static void requireInside(int[] place, RenderSettings settings) {
        int right = settings.width() - 1;
        int bottom = settings.height() - 1;
        if (place[0] < 0 || place[1] < 0 || place[0] > right || place[1] > bottom) {
            throw new MistakeException(String.format(
                    Locale.ROOT, "--pixel must be from 0,0 to %d,%d, was %d,%d", right, bottom, place[0], place[1]));
        }
    }

    private static String json(RayLife life, Studio studio) {
        return life == null ? "null" : RayLifeWriter.json(life, studio);
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
