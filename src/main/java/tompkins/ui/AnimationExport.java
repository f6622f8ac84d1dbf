package tompkins.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.Film;
import tompkins.animation.FrameWarnings;
import tompkins.animation.RideFilm;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FileException;
import tompkins.image.PictureDecoration;
import tompkins.measure.OverlayKind;
import tompkins.render.Progress;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.picture.SceneOverlay;
import tompkins.ui.widget.Texts;

/** Saves an animation as a file, or as a folder of pictures. */
final class AnimationExport {

    private final JFrame frame;
    private final FileDialogs dialogs;
    private final Captions captions;
    private final Signs signs;

    AnimationExport(JFrame frame, FileDialogs dialogs, Captions captions, Signs signs) {
        this.frame = frame;
        this.dialogs = dialogs;
        this.captions = captions;
        this.signs = signs;
    }

    /** Makes a film of a studio, with a number of photographs in a second. */
    private interface FilmMaker {

        Film make(Studio studio, int frameRate);
    }

    /** Asks where to save an animation of a studio. */
    void ask(Studio studio, Animation animation) {
        boolean captioned = captions.areShown();
        ask(
                studio,
                (chosen, rate) -> animation.withFrameRate(rate).film(chosen),
                film -> Captions.ofPictures(studio, animation.number(), captioned));
    }

    /** Asks where to save the film of the ride that begins with a studio. */
    void askForRide(Studio studio) {
        boolean captioned = captions.areShown();
        ask(studio, RideFilm::new, film -> Captions.ofPictures((RideFilm) film, captioned));
    }

    private void ask(Studio studio, FilmMaker maker, Function<Film, Film.Caption> caption) {
        List<FormatFilter<AnimationFormat>> formats = Stream.of(AnimationFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        AnimationOptions options =
                new AnimationOptions(studio, rate -> maker.make(studio, rate).frames());
        JFileChooser chooser = dialogs.chooser();
        chooser.setAccessory(options.component());
        SaveDialog.ask(
                frame, chooser, Texts.get("play.exportTitle"), dialogs.fileName(), formats, (file, format, replace) -> {
                    Film film = maker.make(options.studio(), options.frameRate());
                    save(film, caption.apply(film), file, format, replace);
                });
    }

    /** Saves a film, with progress and cancel. */
    private void save(Film film, Film.Caption caption, Path file, AnimationFormat format, boolean replace) {
        AtomicReference<Exported> exported = new AtomicReference<>();
        Set<OverlayKind> overlays = signs.ofScene();
        Function<Studio, PictureDecoration> decorations =
                moment -> picture -> SceneOverlay.paint(picture, moment, overlays);
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                progress -> exported.set(write(
                        film, caption, decorations, () -> open(file, format, film.frameRate(), replace), progress)),
                () -> dialogs.exported(
                        exported.get().place(), exported.get().warnings().sentences()),
                () -> dialogs.sayNotSaved(file));
    }

    /** What was saved: where it lies, and what the user should know about it. */
    record Exported(Path place, FrameWarnings warnings) {}

    private static AnimationWriter open(Path file, AnimationFormat format, int rate, boolean replace)
            throws FileException {
        return replace ? format.open(file, rate) : format.openNew(file, rate);
    }

    /** Takes all pictures and writes them; leaves nothing behind if the task is cancelled or fails. */
    static Exported write(
            Film film,
            Film.Caption caption,
            Function<Studio, PictureDecoration> decorations,
            Callable<AnimationWriter> file,
            Progress progress)
            throws Exception {
        try (AnimationWriter writer = file.call()) {
            FrameWarnings warnings = AnimationRecorder.record(film, writer, caption, decorations, progress);
            return new Exported(writer.finish(), warnings);
        }
    }
}
