package tompkins.app;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import tompkins.animation.RideFilm;
import tompkins.file.FileException;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.measure.LessonStudio;
import tompkins.property.MistakeException;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.Studio;

/** Looks for mistakes in scene files, and for damage in saved photographs. */
@Command(header = "Looks for mistakes in scene files, and for damage in photographs.")
final class CheckCommand extends ProgramCommand {

    @Parameters(
            arity = "1..*",
            paramLabel = "SCENE",
            description = "scene files, or saved photographs; - is the standard input")
    private List<Path> scenes;

    @Mixin
    private SetOption option;

    private Path current;

    @Override
    Path scene() {
        return current;
    }

    @Override
    public Integer call() {
        int code = 0;
        for (Path scene : scenes) {
            current = scene;
            try {
                Studio studio = option.read(scene, List.of());
                ScenePlan.checked(studio, scene).forEach(warning -> err().println(scene + ": warning: " + warning));
                StudioWriter.notes(studio).forEach(note -> err().println(scene + ": note: " + note));
                requireWhatIsTaught(studio);
                Photographer.info(studio, scene);
                Renderer.requireMemory(studio.settings(), Quality.of(studio));
                if (!scene.equals(StudioReader.PIPE)) {
                    PhotographFile.requireWhole(scene);
                }
                out().println(scene + ": no mistakes");
            } catch (MistakeException mistakes) {
                mistakes.getMessage().lines().forEach(err()::println);
                code = Failures.MISTAKE;
            } catch (FileException damaged) {
                err().println(damaged.getMessage() + "; its scene has no mistakes: render can take the picture again");
                code = Failures.MISTAKE;
            }
        }
        return code;
    }

    /**
     * Refuses a lesson that does not fit its scene, or whose numbers are not those of its formulas, and challenges that
     * their own flights do not meet.
     */
    private void requireWhatIsTaught(Studio studio) {
        StudioReader.used(current, () -> {
            RideFilm.requireChallenges(studio);
            LessonStudio.of(studio).ifPresent(LessonStudio::requireAgreement);
            return studio;
        });
    }
}
