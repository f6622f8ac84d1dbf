package tompkins.ui;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.PhotographInfo;
import tompkins.io.SelfDescription;
import tompkins.render.Quality;
import tompkins.studio.Studio;

/** Saves an animation as a file, or as a folder of pictures. */
final class AnimationExport {

    private final JFrame frame;
    private final StatusBar status;
    private final Supplier<Quality> quality;

    /** An export that takes photographs of the quality that is wanted then. */
    AnimationExport(JFrame frame, StatusBar status, Supplier<Quality> quality) {
        this.frame = frame;
        this.status = status;
        this.quality = quality;
    }

    /** Asks where to save an animation of a studio. */
    void ask(Studio studio, Animation animation) {
        JFileChooser chooser = new JFileChooser();
        chooser.setName("chooser");
        chooser.setDialogTitle(Texts.get("play.export"));
        chooser.setAcceptAllFileFilterUsed(false);
        for (AnimationFormat format : AnimationFormat.values()) {
            if (format.isAvailable()) {
                chooser.addChoosableFileFilter(
                        new FormatFilter<>(format, Texts.get("format." + format), format.endings()));
            }
        }
        chooser.setFileFilter(chooser.getChoosableFileFilters()[0]);
        chooser.setSelectedFile(new File("animation.png"));
        if (chooser.showSaveDialog(frame) == JFileChooser.APPROVE_OPTION
                && chooser.getFileFilter() instanceof FormatFilter<?> filter) {
            AnimationFormat format = (AnimationFormat) filter.format();
            Path file = named(chooser.getSelectedFile().toPath(), format);
            boolean overwrites = !format.endings().isEmpty() && Files.exists(file);
            if (!overwrites
                    || Messages.confirm(
                            frame, Texts.get("file.overwriteTitle"), Texts.get("file.overwrite", file.getFileName()))) {
                save(studio, animation, file, format);
            }
        }
    }

    /** The file with an ending of the format in the place of any other that a picture has. */
    private static Path named(Path file, AnimationFormat format) {
        String name = file.getFileName().toString();
        boolean fits = format.endings().stream().anyMatch(name.toLowerCase(Locale.ROOT)::endsWith);
        if (fits) {
            return file;
        }
        String bare = name.replaceAll("(?i)\\.(a?png|gif|mp4)$", "");
        return file.resolveSibling(
                format.endings().isEmpty() ? bare : bare + format.endings().get(0));
    }

    /** Saves an animation, with progress and cancel. */
    void save(Studio studio, Animation animation, Path file, AnimationFormat format) {
        Quality wanted = quality.get();
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                progress -> write(studio, wanted, animation, file, format, progress),
                () -> status.say(Texts.get("file.saved", file)));
    }

    /** Takes all pictures and writes them; leaves nothing behind if the task is cancelled or fails. */
    static void write(
            Studio studio, Quality quality, Animation animation, Path file, AnimationFormat format, Progress progress)
            throws Exception {
        int frames = animation.frames();
        try (PhotographTaker taker = new PhotographTaker();
                AnimationWriter writer = format.open(
                        file, Animation.FRAME_RATE, studio.settings().toneCurve())) {
            for (int i = 0; i < frames; i++) {
                Studio moment = animation.studio(studio, animation.timeOf(i));
                PhotographInfo info = SelfDescription.of(moment);
                writer.add(taker.take(moment, quality, progress, (double) i / frames, 1.0 / frames), info);
            }
            writer.finish();
        }
    }
}
