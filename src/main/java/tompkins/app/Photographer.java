package tompkins.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import picocli.CommandLine;
import tompkins.file.FileException;
import tompkins.image.LinearImage;
import tompkins.image.PhotographFile;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureFormat;
import tompkins.image.ToneCurve;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.InvalidPropertyException;
import tompkins.property.MistakeException;
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
final class Photographer implements AutoCloseable {

    /**
     * A picture that is to be taken.
     *
     * @param scene the file of the studio
     * @param target where the picture goes
     */
    record Order(Path scene, Studio studio, Quality quality, Path target, PictureFormat format) {

        /** Whether a file is a photograph of the studio, perhaps in another format or damaged. */
        boolean isAt(Path picture) {
            try {
                return Files.isRegularFile(picture)
                        && PhotographFile.readScene(picture)
                                .equals(Optional.of(info(studio, scene).sceneJson()));
            } catch (FileException otherFile) {
                return false;
            }
        }
    }

    private final PrintWriter out;
    private final PrintWriter err;
    private final ProgressLine progress;
    private final int threads;

    /**
     * A photographer that reports to a command line.
     *
     * @param threads number of threads
     */
    Photographer(CommandLine commandLine, int threads) {
        out = commandLine.getOut();
        err = commandLine.getErr();
        progress = new ProgressLine(err);
        this.threads = threads;
    }

    /** Takes the picture of a scene file into a folder; replaces a photograph of the same scene, and nothing else. */
    void takeDefault(Path file, Path folder) throws IOException, InterruptedException {
        reads();
        Studio studio = StudioReader.read(file);
        Order order = new Order(file, studio, Quality.of(studio), targetOf(file, folder), PictureFormat.PNG);
        if (Files.exists(order.target) && !order.isAt(order.target)) {
            throw new MistakeException(
                    order.target + ": there is another file of this name; the command render replaces it with --force");
        }
        take(order, () -> order.isAt(order.target));
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
     * Takes a picture, saves it, and says where. A file that has its name is replaced if that is allowed; otherwise the
     * picture gets a number, so that the work is not lost. Standard output takes the picture and nothing else.
     *
     * @param mayReplace whether a file may be replaced; asked before and after the picture is taken
     */
    void take(Order order, BooleanSupplier mayReplace) throws IOException, InterruptedException {
        Studio studio = order.studio;
        Path target = order.target;
        boolean isPiped = target.equals(StudioReader.PIPE);
        if (isPiped) {
            Renderer.requireMemory(studio.settings(), order.quality);
        } else {
            requirePossible(order, mayReplace);
        }
        // before the work: a scene that is too long is refused
        PhotographInfo before = info(studio, order.scene);
        progress.begin("preparing the objects of the scene");
        RenderPlan plan = ScenePlan.of(studio, order.scene);
        // beside the rays, so that nobody waits for it at the end
        CompletableFuture<List<String>> warnings = CompletableFuture.supplyAsync(() -> ScenePlan.warnings(plan));
        RenderJob job = traced(plan, order.quality);
        progress.clear();
        LinearImage image = job.image();
        // while the file is written, which takes as long
        CompletableFuture<RenderReport> report = CompletableFuture.supplyAsync(() -> job.report(() -> image));
        ToneCurve curve = studio.settings().toneCurve();
        RenderSettings kept = kept(job, order);
        PhotographInfo info = kept == studio.settings() ? before : info(studio.withSettings(kept), order.scene);
        if (isPiped) {
            OutputOption.toPipe(out -> PhotographFile.encode(out, image, order.format, curve, info));
        }
        Path place = isPiped
                ? target
                : PhotographFile.write(target, image, order.format, curve, info, mayReplace.getAsBoolean());
        ScenePlan.warn(warnings.join(), err);
        report(place, report.join(), studio.view());
        if (order.quality instanceof Quality.TimeLimit) {
            err.println("note: taken again it has " + samples(kept.samples()) + " of each pixel");
        }
        tellFilesToKeep(studio, err);
    }

    /** What the photograph says of its quality: a number of samples makes the same picture again, a time does not. */
    private static RenderSettings kept(RenderJob job, Order order) {
        RenderSettings settings = order.studio.settings();
        long mean = Math.max(1, Math.round((double) job.samples() / settings.pixels()));
        return order.quality instanceof Quality.TimeLimit ? settings.withSamples((int) mean) : settings;
    }

    private static String samples(Object number) {
        return number.toString().equals("1") ? "1 sample" : number + " samples";
    }

    /** Says on a terminal that a scene is being read. */
    void reads() {
        progress.begin("reading the scene");
    }

    /** Says that a picture that is there is left. */
    void leave(Path picture) throws IOException {
        progress.clear();
        out.println(picture.toRealPath(LinkOption.NOFOLLOW_LINKS) + "  (left as it is)");
    }

    /** Removes what the terminal shows of a picture that is not complete. */
    @Override
    public void close() {
        progress.clear();
    }

    private RenderJob traced(RenderPlan plan, Quality quality) throws InterruptedException {
        try (Renderer renderer = new Renderer(threads)) {
            progress.begin("tracing rays");
            RenderJob job = renderer.start(plan, quality, progress);
            job.await();
            return job;
        }
    }

    /** Names the files of a scene that are too large to travel inside its photographs. */
    static void tellFilesToKeep(Studio studio, PrintWriter err) {
        List<String> named = StudioWriter.filesOnlyNamed(studio);
        if (!named.isEmpty()) {
            err.println("note: keep " + String.join(", ", named)
                    + " in the same folder to take the photograph again: not stored in it");
        }
    }

    /**
     * Refuses a picture that could not be saved or held, before any time is spent on it; leaves everything as it was.
     */
    static void requirePossible(Order order, BooleanSupplier mayReplace) {
        if (!mayReplace.getAsBoolean()) {
            requireFree(order.target);
        }
        Renderer.requireMemory(order.studio.settings(), order.quality);
        requireWritable(order.target);
    }

    /**
     * Refuses a place where nothing can be saved, or where there is a file that is not to be replaced.
     *
     * @param read the files that the command reads
     */
    static void requirePlace(Path target, boolean replace, Stream<Path> read) {
        NamedFile.requireNotRead(target, read);
        if (!replace) {
            requireFree(target);
        }
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
        NamedFile.used(() -> {
            PhotographFile.requireWritable(target);
            return target;
        });
    }

    /** What a photograph says about itself; a scene that is too long for it is a mistake. */
    static PhotographInfo info(Studio studio, Path scene) {
        try {
            return SelfDescription.of(studio);
        } catch (InvalidPropertyException tooLong) {
            throw new MistakeException(scene + ": the " + tooLong.getMessage());
        }
    }

    private void report(Path target, RenderReport report, View view) throws IOException {
        double seconds = report.time().toNanos() / 1e9;
        boolean isPiped = target.equals(StudioReader.PIPE);
        (isPiped ? err : out)
                .println(String.format(
                        Locale.ROOT,
                        "%s  (%s%.2f s, %.2f million rays/s, %s per pixel%s)",
                        isPiped ? target : target.toRealPath(LinkOption.NOFOLLOW_LINKS),
                        view == View.MEASURED ? "measured, not a photograph; " : "",
                        seconds,
                        (report.counts().rays + report.counts().shadowRays) / seconds / 1e6,
                        samples(NumberText.plain(report.samplesPerPixel(), 3)),
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
        if (file.equals(StudioReader.PIPE)) {
            return wish == null ? PictureFormat.PNG : wish;
        }
        return NamedFile.used(() -> {
            if (wish != null) {
                wish.requireFor(file);
                return wish;
            }
            PictureFormat usual = PictureFormat.of(file);
            Optional<PictureFormat> format =
                    scene.equals(StudioReader.PIPE) ? Optional.empty() : PhotographFile.format(scene);
            return format.filter(before -> before.fits(file)).orElse(usual);
        });
    }
}
