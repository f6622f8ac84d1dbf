package tompkins.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.image.PictureFormat;
import tompkins.io.StudioReader;
import tompkins.property.Require;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** Takes photographs of scene files. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description = "Takes the photographs of scene files. The scene travels inside the picture: render a saved"
                + " photograph to take it again.")
final class RenderCommand implements Callable<Integer>, SceneCommand {

    /** More than the cores of any machine, and not so many that systems refuse to start them. */
    private static final int MOST_THREADS = 1024;

    /** A picture that is to be taken of a scene, and where it goes. */
    private record Order(Studio studio, Quality quality, Path target, PictureFormat format) {}

    @Parameters(arity = "1..*", paramLabel = "SCENE", description = "scene files, or saved photographs")
    private List<Path> scenes;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "the picture (.png, .tif, .tiff, .hdr or .pic), or a folder, which is made if its name ends"
                    + " in / and there is none; default: SCENE.png in the current folder, or SCENE-again.png for a"
                    + " photograph")
    private Path output;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            completionCandidates = OptionWords.Formats.class,
            description = "${COMPLETION-CANDIDATES}; default: that of a photograph that is taken again, or else the"
                    + " usual one for the file's ending: png, tiff (16 bit) or hdr")
    private PictureFormat format;

    @Mixin
    private QualityOptions quality;

    @Mixin
    private PictureOptions picture;

    @Option(names = "--threads", paramLabel = "N", description = "number of threads; default: one per core")
    private Long threads;

    @Option(names = "--force", description = "replace files that are already there")
    private boolean force;

    @Mixin
    private StudioOptions options;

    private Path current;

    @Spec
    private CommandSpec spec;

    @Override
    public Path scene() {
        return current;
    }

    @Override
    public Integer call() throws Exception {
        if (OutputOption.namesFolder(spec)) {
            return OutputOption.inFolder(output, this::takeAll);
        }
        if (scenes.size() > 1 && output != null && !Files.isDirectory(output)) {
            throw new MistakeException("-o must name a folder if there is more than one scene, was " + output
                    + "; write " + output + "/ to make it");
        }
        return takeAll();
    }

    private int takeAll() throws IOException, InterruptedException {
        Photographer photographer = new Photographer(spec.commandLine(), threads());
        if (scenes.size() > 1) {
            requireAllPossible();
        }
        for (Path scene : scenes) {
            Order order = order(scene);
            photographer.take(scene, order.studio, order.quality, order.target, order.format, target -> force);
        }
        return 0;
    }

    /**
     * Looks for mistakes in all scenes first, so that one in the last scene is not found after an hour of work. The
     * scenes are not kept but read again when it is their turn, because all at once may be more than the memory holds.
     */
    private void requireAllPossible() throws IOException {
        Map<Path, Path> sources = new HashMap<>();
        for (Path scene : scenes) {
            Order order = order(scene);
            Path other = sources.putIfAbsent(order.target, scene);
            if (other != null) {
                throw new MistakeException(scene + ": its picture would be " + order.target + ", as that of " + other
                        + "; render one of them alone, with another name after -o");
            }
            Photographer.requirePossible(order.studio, order.quality, order.target, target -> force);
            ScenePlan.of(order.studio, scene);
            Photographer.info(order.studio, scene);
        }
    }

    /** The picture to take of a scene. */
    private Order order(Path scene) throws IOException {
        current = scene;
        // read first: what can be read has a name, and so has its picture
        Studio studio = studio(scene);
        Path target = target(scene);
        return new Order(studio, quality.of(studio), target, Photographer.formatFor(target, format, scene));
    }

    private Path target(Path scene) throws IOException {
        if (output == null) {
            return Photographer.targetOf(scene, Path.of(""));
        }
        return Files.isDirectory(output) ? Photographer.targetOf(scene, output) : output;
    }

    private int threads() {
        return threads == null
                ? Runtime.getRuntime().availableProcessors()
                : MistakeException.inOption("--threads", () -> Require.within("threads", threads, 1, MOST_THREADS));
    }

    private Studio studio(Path scene) {
        return picture.applyTo(quality.applyTo(options.applyTo(StudioReader.read(scene))));
    }
}
