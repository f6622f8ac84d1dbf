package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import picocli.CommandLine;
import tompkins.image.FileException;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.render.Quality;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.render.Renderer;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.RenderPlan;

/** Takes photographs and saves them, with the scene inside. */
final class Photographer {

    private final PrintWriter out;
    private final PrintWriter err;
    private final int threads;

    /**
     * A photographer that reports to a command line.
     *
     * @param threads number of threads
     */
    Photographer(CommandLine commandLine, int threads) {
        out = commandLine.getOut();
        err = commandLine.getErr();
        this.threads = threads;
    }

    /**
     * Takes the picture of a scene file into a folder, under its own name or, where that is taken, with a number. A
     * photograph of the same scene is replaced, and nothing else.
     */
    void takeDefault(Path file, Path folder) throws IOException, InterruptedException {
        Studio studio = StudioReader.read(file);
        Predicate<Path> isPhotograph = place -> isPhotographOf(place, studio, file);
        Path target = free(targetOf(file, folder), place -> Files.exists(place) && !isPhotograph.test(place));
        take(file, studio, Quality.of(studio), target, PictureFormat.of(target), isPhotograph);
    }

    /** The name of a picture; if it is taken, the same name with the first free number before its ending. */
    private static Path free(Path target, Predicate<Path> isTaken) {
        String name = target.getFileName().toString();
        int dot = name.lastIndexOf('.');
        Path free = target;
        for (int number = 2; isTaken.test(free); number++) {
            free = target.resolveSibling(name.substring(0, dot) + "-" + number + name.substring(dot));
        }
        return free;
    }

    private static boolean isPhotographOf(Path picture, Studio studio, Path scene) {
        try {
            return Files.isRegularFile(picture)
                    && PhotographFile.readScene(picture)
                            .equals(Optional.of(info(studio, scene).sceneJson()));
        } catch (FileException otherFile) {
            return false;
        }
    }

    /**
     * The name of the picture of a scene, in a folder: {@code scene.png}, or {@code scene-again.png} for a photograph.
     */
    static Path targetOf(Path scene, Path folder) throws IOException {
        String name = scene.getFileName().toString();
        int dot = name.lastIndexOf('.');
        String stem = dot > 0 ? name.substring(0, dot) : name;
        return folder.resolve(stem + (PhotographFile.isPicture(scene) ? "-again" : "") + ".png");
    }

    /**
     * Takes the picture of a scene file, saves it, and says where. A file that has its name is replaced if that is
     * allowed; otherwise the picture gets a number, so that the work is not lost.
     *
     * @param mayReplace whether a file may be replaced; asked before and after the picture is taken
     */
    void take(Path scene, Studio studio, Quality quality, Path target, PictureFormat format, Predicate<Path> mayReplace)
            throws IOException, InterruptedException {
        requirePossible(studio, quality, target, mayReplace);
        PhotographInfo info = info(studio, scene);
        RenderPlan plan = ScenePlan.of(studio, scene);
        ProgressLine progress = new ProgressLine(err);
        RenderJob job;
        try (Renderer renderer = new Renderer(threads)) {
            job = renderer.start(plan, quality, progress);
            job.await();
        } finally {
            progress.clear();
        }
        ToneCurve curve = studio.settings().toneCurve();
        Path place = target;
        if (mayReplace.test(target)) {
            PhotographFile.write(target, job.image(), format, curve, info);
        } else {
            place = PhotographFile.writeNew(target, job.image(), format, curve, info);
        }
        plan.warnings().forEach(warning -> err.println("warning: " + warning));
        report(place, job.report(), studio.view());
        tellFilesToKeep(studio, err);
    }

    /** Names the files of a scene that are too large to travel inside its photographs. */
    static void tellFilesToKeep(Studio studio, PrintWriter err) {
        List<String> named = StudioWriter.filesOnlyNamed(studio);
        if (!named.isEmpty()) {
            err.println("note: keep " + String.join(", ", named)
                    + " in the same folder to take the photograph again: too large to store in it");
        }
    }

    /**
     * Refuses a picture that could not be saved or held, before any time is spent on it; leaves everything as it was.
     */
    static void requirePossible(Studio studio, Quality quality, Path target, Predicate<Path> mayReplace) {
        if (!mayReplace.test(target)) {
            requireFree(target);
        }
        requireMemory(studio.settings(), quality);
        requireWritable(target);
    }

    /** Refuses the name of a file that exists. */
    static void requireFree(Path target) {
        if (Files.isRegularFile(target)) {
            throw new MistakeException(target + ": there is a file of this name already; --force replaces it");
        }
    }

    /** Refuses a place where nothing can be saved. */
    static void requireWritable(Path target) {
        try {
            PhotographFile.requireWritable(target);
        } catch (FileException wrongPlace) {
            // not a failure of the disk: the user named the place
            throw new MistakeException(wrongPlace.getMessage());
        }
    }

    /** What a photograph says about itself; a scene that is too long for it is a mistake. */
    static PhotographInfo info(Studio studio, Path scene) {
        try {
            return SelfDescription.of(studio);
        } catch (InvalidPropertyException tooLong) {
            throw new MistakeException(scene + ": the " + tooLong.getMessage());
        }
    }

    /** Refuses pictures that the memory of this Java machine cannot hold, before any time is spent on them. */
    static void requireMemory(RenderSettings settings, Quality quality) {
        long needed = Renderer.bytesOfMemory(settings, quality);
        long most = Runtime.getRuntime().maxMemory();
        if (needed > most) {
            throw new MistakeException(String.format(
                    Locale.ROOT,
                    "a picture of %d x %d pixels needs about %d MB of memory, and Java may use %d MB;"
                            + " take a smaller --size, or start java with a larger -Xmx",
                    settings.width(),
                    settings.height(),
                    needed >> 20,
                    most >> 20));
        }
    }

    private void report(Path target, RenderReport report, View view) throws IOException {
        double seconds = report.time().toNanos() / 1e9;
        String samples = NumberText.plain(report.samplesPerPixel(), 3);
        out.println(String.format(
                Locale.ROOT,
                "%s  (%s%.2f s, %.2f million rays/s, %s per pixel%s)",
                target.toRealPath(LinkOption.NOFOLLOW_LINKS),
                view == View.MEASURED ? "measured, not a photograph; " : "",
                seconds,
                (report.rays() + report.shadowRays()) / seconds / 1e6,
                samples.equals("1") ? "1 sample" : samples + " samples",
                Double.isNaN(report.error())
                        ? ""
                        : String.format(Locale.ROOT, ", estimated error %.2g", report.error())));
        for (String warning : report.warnings()) {
            err.println("warning: " + warning);
        }
    }

    /**
     * The format for a picture's file: the wish, if there is one; or that of the photograph that is taken again, if the
     * file's name allows it; or the usual one for the name.
     */
    static PictureFormat formatFor(Path file, PictureFormat wish, Path scene) {
        try {
            if (wish == null) {
                PictureFormat usual = PictureFormat.of(file);
                return PhotographFile.format(scene)
                        .filter(before -> before.fits(file))
                        .orElse(usual);
            }
            wish.requireFor(file);
            return wish;
        } catch (FileException wrongName) {
            throw new MistakeException(wrongName.getMessage());
        }
    }
}
