package tompkins.ui.animate;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.FrameSequence;
import tompkins.animation.RideFilm;
import tompkins.file.OutputFolder;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FrameFolder;
import tompkins.image.FramePicture;
import tompkins.measure.OverlayKind;
import tompkins.render.Progress;
import tompkins.studio.Studio;
import tompkins.ui.exchange.FileDialogs;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.overlay.PictureOverlays;
import tompkins.ui.overlay.SceneOverlay;
import tompkins.ui.photograph.Captions;
import tompkins.ui.widget.Texts;

/** Saves an animation as a file, or as a folder of pictures. */
public final class AnimationExport {

    private final JFrame frame;
    private final FileDialogs dialogs;
    private final Captions captions;
    private final PictureOverlays overlays;

    /** Exports animations of a window, with the captions and overlays that it shows. */
    public AnimationExport(JFrame frame, FileDialogs dialogs, Captions captions, PictureOverlays overlays) {
        this.frame = frame;
        this.dialogs = dialogs;
        this.captions = captions;
        this.overlays = overlays;
    }

    /** Asks where to save an animation of a studio. */
    public void ask(Studio studio, Animation animation) {
        boolean captioned = captions.areShown();
        ask(
                studio,
                (chosen, rate) -> animation.withFrameRate(rate).sequence(chosen),
                film -> Captions.ofPictures(studio, animation.number(), captioned));
    }

    /** Asks where to save the film of the ride that begins with a studio. */
    public void askForRide(Studio studio) {
        boolean captioned = captions.areShown();
        ask(studio, RideFilm::new, film -> Captions.ofPictures((RideFilm) film, captioned));
    }

    /** Asks the same; {@code maker} makes the film of a studio with a number of photographs in a second. */
    private void ask(
            Studio studio,
            BiFunction<Studio, Integer, FrameSequence> maker,
            Function<FrameSequence, FrameSequence.Caption> caption) {
        List<FormatFilter<AnimationFormat>> formats = Stream.of(AnimationFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        AnimationOptions options =
                new AnimationOptions(studio, rate -> maker.apply(studio, rate).frames());
        JFileChooser chooser = dialogs.chooser();
        chooser.setAccessory(options.component());
        SaveDialog.ask(
                frame, chooser, Texts.get("play.exportTitle"), dialogs.fileName(), formats, (file, format, replace) -> {
                    FrameSequence film = maker.apply(options.studio(), options.frameRate());
                    save(film, caption.apply(film), file, format, replace);
                });
    }

    /** Saves a film, with progress and cancel. */
    private void save(
            FrameSequence film, FrameSequence.Caption caption, Path file, AnimationFormat format, boolean replace) {
        Set<OverlayKind> drawn = overlays.ofScene();
        Function<Studio, Consumer<FramePicture>> decorations =
                moment -> picture -> SceneOverlay.paint(picture.image(), moment, drawn);
        int threads = Runtime.getRuntime().availableProcessors();
        AnimationRecorder recorder = new AnimationRecorder(film, caption, decorations, threads);
        dialogs.save(
                file,
                progress -> write(recorder, file, format, replace, progress),
                exported -> dialogs.exported(exported.place(), exported.warnings()));
    }

    /** What was saved: where it lies, and what the user should know about it. */
    record Exported(Path place, List<String> warnings) {}

    /** Takes all pictures; what is cancelled or fails leaves at most whole pictures in a folder. */
    static Exported write(
            AnimationRecorder recorder, Path file, AnimationFormat format, boolean replace, Progress progress)
            throws Exception {
        FrameSequence film = recorder.film();
        if (format == AnimationFormat.NUMBERED_PNG) {
            OutputFolder folder = OutputFolder.emptyAt(file);
            try {
                return new Exported(
                        file, recorder.record(recorder.allFrames(), new FrameFolder(file), false, progress));
            } finally {
                folder.close();
            }
        }
        try (AnimationWriter writer = format.open(file, film.frameRate(), replace)) {
            List<String> warnings = recorder.record(writer, progress);
            return new Exported(writer.finish(), warnings);
        }
    }
}
