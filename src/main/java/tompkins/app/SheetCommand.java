package tompkins.app;

import java.io.IOException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.io.LessonSheet;
import tompkins.io.StudioReader;
import tompkins.measure.LessonResult;
import tompkins.measure.LessonStudio;
import tompkins.render.PhotographTaker;
import tompkins.render.Quality;
import tompkins.render.Renderer;
import tompkins.studio.Studio;

/** Makes sheets of lessons, to be printed. */
@Command(
        header = "Makes a sheet of lessons, to be printed.",
        description =
                "A browser prints it: the questions with their pictures, and room to write and to measure. A second page"
                        + " beside it, with -answers in its name, has the answers.")
final class SheetCommand extends ProgramCommand {

    @Parameters(
            paramLabel = "SCENE",
            arity = "1..*",
            description = "scene files with lessons, or saved photographs; - is the standard input")
    private List<Path> scenes;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the sheet, a page in HTML that holds its pictures")
    private Path output;

    @Option(names = "--force", description = "replace files of these names")
    private boolean force;

    @Mixin
    private ThreadsOption threads;

    @Mixin
    private SampledOptions options;

    @Override
    public Integer call() throws IOException, InterruptedException {
        NamedFile.requireEnding(output, "sheet", ".html", ".htm");
        List<LessonStudio> lessons = new ArrayList<>();
        for (Path scene : scenes) {
            Studio studio = options.read(scene, List.of());
            ScenePlan.of(studio, scene);
            for (Path page : List.of(output, LessonSheet.answersOf(output))) {
                Photographer.requirePlace(page, force, NamedFile.ofScene(studio, scene));
            }
            Renderer.requireMemory(studio.settings(), Quality.of(studio));
            lessons.add(ScenePlan.lesson(studio, scene));
        }
        for (Path page : LessonSheet.save(sheets(lessons), output, force)) {
            out().println(page.toRealPath(LinkOption.NOFOLLOW_LINKS));
        }
        return 0;
    }

    private List<LessonSheet> sheets(List<LessonStudio> lessons) throws IOException, InterruptedException {
        List<LessonSheet> sheets = new ArrayList<>();
        ProgressLine progress = new ProgressLine(err());
        try (PhotographTaker taker = new PhotographTaker(threads.number())) {
            for (int i = 0; i < lessons.size(); i++) {
                LessonStudio lesson = lessons.get(i);
                List<LessonResult> results = StudioReader.used(scenes.get(i), lesson::results);
                sheets.add(LessonSheet.of(lesson, results, taker, progress));
            }
        } finally {
            progress.clear();
        }
        return sheets;
    }
}
