package tompkins.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JFrame;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.Film;
import tompkins.animation.FrameWarnings;
import tompkins.animation.RideFilm;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FileException;
import tompkins.render.Progress;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.widget.Texts;

/** Saves an animation as a file, or as a folder of pictures. */
final class AnimationExport {

    private final JFrame frame;
    private final FileDialogs dialogs;
    private final Captions captions;

    AnimationExport(JFrame frame, FileDialogs dialogs, Captions captions) {
        this.frame = frame;
        this.dialogs = dialogs;
        this.captions = captions;
    }

    /** Asks where to save an animation of a studio. */
    void ask(Studio studio, Animation animation) {
        ask(animation.film(studio), wanted -> Captions.ofPictures(studio, animation.number(), wanted));
    }

    /** Asks where to save the film of a ride. */
    void ask(RideFilm film) {
        ask(film, wanted -> Captions.ofPictures(film, wanted));
    }

    private void ask(Film film, Function<Boolean, Film.Caption> caption) {
        List<FormatFilter<AnimationFormat>> formats = Stream.of(AnimationFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        RenderSettings size = film.studio(0).settings();
        SaveDialog.ask(
                frame,
                dialogs.chooser(),
                Texts.get("play.exportTitle", film.frames(), size.width(), size.height()),
                "animation",
                formats,
                (file, format, replace) -> save(film, caption.apply(captions.areShown()), file, format, replace));
    }

    /** Saves a film, with progress and cancel. */
    private void save(Film film, Film.Caption caption, Path file, AnimationFormat format, boolean replace) {
        AtomicReference<Exported> exported = new AtomicReference<>();
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                progress -> exported.set(write(film, caption, () -> open(file, format, replace), progress)),
                () -> dialogs.exported(
                        exported.get().place(), exported.get().warnings().sentences()),
                () -> dialogs.sayNotSaved(file));
    }

    /** What was saved: where it lies, and what the user should know about it. */
    record Exported(Path place, FrameWarnings warnings) {}

    private static AnimationWriter open(Path file, AnimationFormat format, boolean replace) throws FileException {
        return replace ? format.open(file, Film.FRAME_RATE) : format.openNew(file, Film.FRAME_RATE);
    }

    /** Takes all pictures and writes them; leaves nothing behind if the task is cancelled or fails. */
    static Exported write(Film film, Film.Caption caption, Callable<AnimationWriter> file, Progress progress)
            throws Exception {
        try (AnimationWriter writer = file.call()) {
            FrameWarnings warnings = AnimationRecorder.record(film, writer, caption, progress);
            return new Exported(writer.finish(), warnings);
        }
    }
}
