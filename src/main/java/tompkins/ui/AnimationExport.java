package tompkins.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.FrameWarnings;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FileException;
import tompkins.render.Progress;
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
        List<FormatFilter<AnimationFormat>> formats = Stream.of(AnimationFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        AnimationOptions options = new AnimationOptions(studio, animation);
        JFileChooser chooser = dialogs.chooser();
        chooser.setAccessory(options.component());
        SaveDialog.ask(
                frame,
                chooser,
                Texts.get("play.exportTitle"),
                dialogs.fileName(),
                formats,
                (file, format, replace) -> save(options.studio(), options.animation(), file, format, replace));
    }

    /** Saves an animation, with progress and cancel. */
    void save(Studio studio, Animation animation, Path file, AnimationFormat format, boolean replace) {
        boolean captioned = captions.areShown();
        AtomicReference<Exported> exported = new AtomicReference<>();
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                progress -> exported.set(write(
                        studio,
                        animation,
                        () -> open(file, format, animation.frameRate(), replace),
                        captioned,
                        progress)),
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
            Studio studio, Animation animation, Callable<AnimationWriter> file, boolean captioned, Progress progress)
            throws Exception {
        try (AnimationWriter writer = file.call()) {
            Function<Studio, String> caption = Captions.ofPictures(studio, animation.number(), captioned);
            FrameWarnings warnings = AnimationRecorder.record(studio, animation, writer, caption, progress);
            return new Exported(writer.finish(), warnings);
        }
    }
}
