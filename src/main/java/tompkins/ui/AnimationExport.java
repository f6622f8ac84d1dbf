package tompkins.ui;

import java.nio.file.Path;
import java.util.List;
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
                (file, format) -> save(options.studio(), options.animation(), file, format));
    }

    /** Saves an animation, with progress and cancel. */
    void save(Studio studio, Animation animation, Path file, AnimationFormat format) {
        boolean captioned = captions.areShown();
        AtomicReference<FrameWarnings> warnings = new AtomicReference<>();
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                progress -> warnings.set(write(studio, animation, file, format, captioned, progress)),
                () -> dialogs.exported(file, warnings.get().sentences()),
                () -> dialogs.sayNotSaved(file));
    }

    /** Takes all pictures and writes them; leaves nothing behind if the task is cancelled or fails. */
    static FrameWarnings write(
            Studio studio, Animation animation, Path file, AnimationFormat format, boolean captioned, Progress progress)
            throws Exception {
        try (AnimationWriter writer = format.open(file, animation.frameRate())) {
            Function<Studio, String> caption = Captions.ofPictures(studio, animation.number(), captioned);
            return AnimationRecorder.record(studio, animation, writer, caption, progress);
        }
    }
}
