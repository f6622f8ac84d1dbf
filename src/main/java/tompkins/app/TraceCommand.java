package tompkins.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
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
import tompkins.spacetime.Event;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;

/** Shows the life of one ray. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description = "Shows the life of one ray: its events and directions in both frames, its hits, its colour. Where"
                + " it splits, as in glass, all hits of the weaker branch come first, indented; entry and frequency are those of"
                + " the main branch. The share is the most light of the pixel that the ray of a hit can still add.")
final class TraceCommand implements Callable<Integer> {

    /** Half of the way from the centre of the lens to its right edge. */
    private static final String PUPIL_EXAMPLE = "0.5,0";

    @Parameters(paramLabel = "SCENE", description = "scene file, or saved photograph")
    private Path scene;

    @Option(
            names = "--pixel",
            required = true,
            paramLabel = "X,Y",
            description = "column and row of the pixel, from 0 at the upper left; its centre is taken")
    private String pixel;

    @Option(
            names = "--pupil",
            defaultValue = "0,0",
            paramLabel = "X,Y",
            description = "point of the lens in units of its radius, to the right and up; default: its centre")
    private String pupil;

    @Option(
            names = "--json",
            description = "print JSON with 17 significant digits; null for a ray that never crosses the shutter")
    private boolean json;

    @Mixin
    private StudioOptions options;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        int[] place = StudioOptions.pair(
                pixel, ",", "--pixel must be two whole numbers inside the picture with a comma between them");
        double[] lens = StudioOptions.numbers("--pupil", pupil, PUPIL_EXAMPLE);
        Studio studio = options.applyTo(StudioReader.read(scene));
        int width = studio.settings().width();
        int height = studio.settings().height();
        if (place[0] < 0 || place[1] < 0 || place[0] >= width || place[1] >= height) {
            throw new MistakeException(String.format(
                    Locale.ROOT, "--pixel must be from 0,0 to %d,%d, was %s", width - 1, height - 1, pixel));
        }
        if (Math.hypot(lens[0], lens[1]) > 1) {
            throw new MistakeException(
                    "--pupil must lie in the unit disc, such as --pupil=" + PUPIL_EXAMPLE + ", was " + pupil);
        }
        RayLife life = RayLife.of(ScenePlan.of(studio, scene), place[0] + 0.5, place[1] + 0.5, lens[0], lens[1]);
        PrintWriter out = spec.commandLine().getOut();
        if (life == null) {
            out.println(json ? "null" : "This ray never crosses the shutter: it brings no light and has no events.");
        } else if (json) {
            out.println(RayLifeWriter.json(life, studio));
        } else {
            print(out, life, studio);
        }
        return 0;
    }

    private static void print(PrintWriter out, RayLife life, Studio studio) {
        out.println("Camera frame");
        printStart(out, life.cameraStart(), life.cameraDirection());
        if (life.sceneStart() != null) {
            out.println("Scene frame");
            printStart(out, life.sceneStart(), life.sceneDirection());
        }
        out.println(format("frequency ratio (camera/scene)  %.12g", life.frequencyRatio()));
        SpeedScale scale = studio.transformation().speedScale();
        out.println(format("%-30s  %.12g", scale.key(), scale.valueOf(studio.velocity())));
        for (RayLife.Encounter hit : life.hits()) {
            out.println(format(
                    "%shit  %s (%s) in the %s frame at %s, t = %.9g, distance %.9g, share %s",
                    "  ".repeat(hit.branch()),
                    OneLine.of(hit.object()),
                    hit.surface().getClass().getSimpleName(),
                    hit.frame().name().toLowerCase(Locale.ROOT),
                    text(hit.event().position()),
                    hit.event().time(),
                    hit.distance(),
                    NumberText.plain(hit.share(), 4)));
        }
        if (life.hits().isEmpty() && life.reachesBackground()) {
            out.println("hits nothing: the background");
        }
        out.println(format(
                "colour (linear)  %.9g, %.9g, %.9g",
                life.colour().red(), life.colour().green(), life.colour().blue()));
    }

    private static void printStart(PrintWriter out, Event event, Vector3dc direction) {
        out.println("  position   " + text(event.position()));
        out.println(format("  time       %.12g", event.time()));
        out.println("  direction  " + text(direction));
    }

    private static String text(Vector3dc vector) {
        return format("(%.9g, %.9g, %.9g)", vector.x(), vector.y(), vector.z());
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
