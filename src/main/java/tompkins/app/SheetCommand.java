package tompkins.app;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.file.PendingFile;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
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
        header = "Makes a sheet of a lesson, to be printed.",
        description =
                "A browser prints it: the question with its picture, room to write and to measure, and on the last"
                        + " page the answers.")
final class SheetCommand extends ProgramCommand {

    @Parameters(
            paramLabel = "SCENE",
            description = "scene file with a lesson, or saved photograph; - is the standard input")
    private Path scene;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the sheet, a page in HTML that holds its picture")
    private Path output;

    @Option(names = "--force", description = "replace a file of this name")
    private boolean force;

    @Mixin
    private ThreadsOption threads;

    @Mixin
    private SampledOptions options;

    @Override
    public Integer call() throws IOException, InterruptedException {
        Studio studio = options.read(scene, List.of());
        NamedFile.requireEnding(output, "sheet", ".html", ".htm");
        ScenePlan.of(studio, scene);
        Photographer.requirePlace(output, force, NamedFile.ofScene(studio, scene));
        Renderer.requireMemory(studio.settings(), Quality.of(studio));
        byte[] page = sheet(studio).html().getBytes(StandardCharsets.UTF_8);
        Path place = PendingFile.save(output, force, out -> out.write(page));
        out().println(place.toRealPath(LinkOption.NOFOLLOW_LINKS));
        return 0;
    }

    private LessonSheet sheet(Studio studio) throws IOException, InterruptedException {
        LessonStudio lesson = ScenePlan.lesson(studio, scene);
        List<LessonResult> results = StudioReader.used(scene, lesson::results);
        return new LessonSheet(
                studio.title(),
                studio.remarks(),
                lesson.lesson(),
                picture(studio),
                picture(lesson.measured()),
                results);
    }

    /** The picture alone: the scene in it would hold the answers. */
    private byte[] picture(Studio studio) throws IOException, InterruptedException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ProgressLine progress = new ProgressLine(err());
        try (PhotographTaker taker = new PhotographTaker(threads.number())) {
            PhotographFile.encode(
                    png,
                    taker.take(studio, progress, 0, 1).image(),
                    PictureFormat.PNG,
                    ToneCurve.SRGB,
                    PhotographInfo.NONE);
        } finally {
            progress.clear();
        }
        return png.toByteArray();
    }
}
