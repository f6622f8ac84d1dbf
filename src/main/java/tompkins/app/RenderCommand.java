package tompkins.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.file.FileException;
import tompkins.image.PhotographFile;
import tompkins.image.PictureFormat;
import tompkins.io.StudioReader;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;

/** Takes photographs of scene files. */
@Command(
        header = "Takes photographs of scene files.",
        description = "The scene travels inside the picture: render a saved" + " photograph to take it again.")
final class RenderCommand extends ProgramCommand {

    @Parameters(
            arity = "1..*",
            paramLabel = "SCENE",
            description = "scene files, or saved photographs; - is the standard input")
    private List<Path> scenes;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description =
                    "the picture (.png, .tif, .tiff, .hdr or .pic; - is the standard output), or a folder (a new one"
                            + " ends in /); default: SCENE.png in the current folder, or SCENE-again.png for a photograph")
    private Path output;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            description =
                    "png, png16, tiff (16 bit), tiff_float or hdr; default: by the name of the picture, or as in the"
                            + " photograph that is taken again")
    private PictureFormat format;

    @Mixin
    private ThreadsOption threads;

    @Mixin
    private QualityOptions quality;

    @Mixin
    private ManyPictures pictures;

    @Mixin
    private SampledOptions options;

    private Path current;

    @Override
    Path scene() {
        return current;
    }

    @Override
    public Integer call() throws Exception {
        if (pictures.skips() && commandLine().getParseResult().hasMatchedOption("--seconds")) {
            throw new MistakeException(
                    "--skip-existing: a picture does not hold for how many --seconds it was taken; use"
                            + " --samples or --error");
        }
        if (scenes.contains(StudioReader.PIPE) && (scenes.size() > 1 || !namesFile())) {
            throw new MistakeException("the scene - is the standard input, which has no name for a picture: give it"
                    + " alone, with a name after -o; -o - is the standard output");
        }
        if (OutputOption.namesFolder(commandLine())) {
            return OutputOption.inFolder(output, this::takeAll);
        }
        if (scenes.size() > 1 && output != null && !Files.isDirectory(output)) {
            throw new MistakeException("-o must name a folder if there is more than one scene, was " + output
                    + "; write " + output + "/ to make it");
        }
        return takeAll();
    }

    private boolean namesFile() {
        return output != null && !OutputOption.namesFolder(commandLine()) && !Files.isDirectory(output);
    }

    private int takeAll() throws IOException, InterruptedException {
        try (Photographer photographer = new Photographer(commandLine(), threads.number())) {
            photographer.reads();
            List<Path> own = pictures.own(scenes);
            if (own.size() > 1) {
                requireAllPossible(own);
            }
            for (int i = 0; i < own.size(); i++) {
                photographer.reads();
                Photographer.Order order = order(own.get(i));
                if (isDone(order)) {
                    photographer.leave(order.target());
                } else {
                    requireNotRead(order);
                    photographer.take(order, () -> mayReplace(order));
                }
            }
            return 0;
        }
    }

    /**
     * Looks for mistakes in all scenes first, so that one in the last scene is not found after an hour of work. The
     * scenes are not kept but read again when it is their turn, because all at once may be more than the memory holds.
     */
    private void requireAllPossible(List<Path> own) throws IOException {
        Map<Path, Path> sources = new HashMap<>();
        for (Path scene : own) {
            Photographer.Order order = order(scene);
            Path other = sources.putIfAbsent(order.target(), scene);
            if (other != null) {
                throw new MistakeException(scene + ": its picture would be " + order.target() + ", as that of " + other
                        + "; render one of them alone, with another name after -o");
            }
            if (isDone(order)) {
                continue;
            }
            requireNotRead(order);
            Photographer.requirePossible(order, () -> mayReplace(order));
            ScenePlan.of(order.studio(), scene);
            Photographer.info(order.studio(), scene);
        }
    }

    /** A photograph may be replaced by itself, taken again, since the scene stays in it; another file is kept. */
    private void requireNotRead(Photographer.Order order) {
        Stream<Path> read = Stream.concat(scenes.stream(), NamedFile.ofScene(order.studio(), order.scene()));
        NamedFile.requireNotRead(order.target(), read.filter(file -> !file.equals(order.scene())));
    }

    /** Whether the picture is there, whole, and is to be left. */
    private boolean isDone(Photographer.Order order) {
        try {
            if (!isFound(order)) {
                return false;
            }
            PhotographFile.requireWhole(order.target());
            return true;
        } catch (FileException damaged) {
            return false;
        }
    }

    /** Whether the same picture is there, perhaps damaged, and is looked for. */
    private boolean isFound(Photographer.Order order) throws FileException {
        return pictures.skips()
                && order.isAt(order.target())
                && PhotographFile.format(order.target()).equals(Optional.of(order.format()));
    }

    /** Whether the picture replaces what has its name: a damaged one of the same scene is mended. */
    private boolean mayReplace(Photographer.Order order) {
        try {
            return pictures.force() || isFound(order);
        } catch (FileException unreadable) {
            return false;
        }
    }

    /** The picture to take of a scene. */
    private Photographer.Order order(Path scene) throws IOException {
        current = scene;
        // read first: what can be read has a name, and so has its picture
        Studio studio = options.read(scene, quality.assignments());
        Path target = target(scene);
        return new Photographer.Order(
                scene, studio, quality.of(studio), target, Photographer.formatFor(target, format, scene));
    }

    private Path target(Path scene) throws IOException {
        if (StudioReader.PIPE.equals(output)) {
            return output;
        }
        if (output == null) {
            return Photographer.targetOf(scene, NamedFile.currentFolder());
        }
        return Files.isDirectory(output) ? Photographer.targetOf(scene, output) : output;
    }
}
