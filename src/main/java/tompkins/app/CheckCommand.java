package tompkins.app;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tompkins.experiment.LessonStudio;
import tompkins.image.FileException;
import tompkins.image.PhotographFile;
import tompkins.io.SceneFileException;
import tompkins.io.StudioReader;
import tompkins.property.InvalidPropertyException;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** Looks for mistakes in scene files, and for damage in saved photographs. */
@Command(
        mixinStandardHelpOptions = true,
        versionProvider = ProgramVersion.class,
        description = "Looks for mistakes in scene files, and for damage in saved photographs.")
final class CheckCommand implements Callable<Integer>, SceneCommand {

    @Parameters(arity = "1..*", paramLabel = "SCENE", description = "scene files, or saved photographs")
    private List<Path> scenes;

    private Path current;

    @Spec
    private CommandSpec spec;

    @Override
    public Path scene() {
        return current;
    }

    @Override
    public Integer call() {
        int code = 0;
        for (Path scene : scenes) {
            current = scene;
            try {
                Studio studio = StudioReader.read(scene);
                ScenePlan.of(studio, scene)
                        .warnings()
                        .forEach(warning -> spec.commandLine().getErr().println(scene + ": warning: " + warning));
                requireLesson(studio);
                Photographer.info(studio, scene);
                Photographer.requireMemory(studio.settings(), Quality.of(studio));
                PhotographFile.requireWhole(scene);
                spec.commandLine().getOut().println(scene + ": no mistakes");
            } catch (SceneFileException | MistakeException mistakes) {
                spec.commandLine().getErr().println(mistakes.getMessage());
                code = Failures.MISTAKE;
            } catch (FileException damaged) {
                spec.commandLine()
                        .getErr()
                        .println(damaged.getMessage()
                                + "; its scene has no mistakes: render can take the picture again");
                code = Failures.MISTAKE;
            }
        }
        return code;
    }

    /** Refuses a lesson that does not fit its scene, or whose numbers are not those of its formulas. */
    private void requireLesson(Studio studio) {
        try {
            LessonStudio.of(studio).ifPresent(LessonStudio::requireAgreement);
        } catch (InvalidPropertyException wrong) {
            throw new MistakeException(current + ": " + wrong.getMessage());
        }
    }
}
