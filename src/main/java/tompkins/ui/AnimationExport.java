package tompkins.ui;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFrame;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.BufferedImages;
import tompkins.image.LinearImage;
import tompkins.image.PhotographInfo;
import tompkins.image.ToneCurve;
import tompkins.io.SelfDescription;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.studio.Studio;
import tompkins.ui.file.BackgroundTask;
import tompkins.ui.file.FormatFilter;
import tompkins.ui.file.SaveDialog;
import tompkins.ui.panel.Animation;
import tompkins.ui.picture.PictureLabel;
import tompkins.ui.widget.Texts;

/** Saves an animation as a file, or as a folder of pictures. */
final class AnimationExport {

    private final JFrame frame;
    private final FileActions files;
    private final Captions captions;

    AnimationExport(JFrame frame, FileActions files, Captions captions) {
        this.frame = frame;
        this.files = files;
        this.captions = captions;
    }

    /** Asks where to save an animation of a studio. */
    void ask(Studio studio, Animation animation) {
        List<FormatFilter<AnimationFormat>> formats = Stream.of(AnimationFormat.values())
                .map(format -> new FormatFilter<>(format, Texts.get("format." + format), format.endings()))
                .toList();
        SaveDialog.ask(
                frame,
                files.chooser(),
                Texts.get("play.exportTitle"),
                "animation",
                formats,
                (file, format) -> save(studio, animation, file, format));
    }

    /** Saves an animation, with progress and cancel. */
    void save(Studio studio, Animation animation, Path file, AnimationFormat format) {
        boolean captioned = captions.areShown();
        BackgroundTask.start(
                frame,
                Texts.get("file.saving", file),
                progress -> write(studio, animation, file, format, captioned, progress),
                () -> files.exported(file));
    }

    /** Takes all pictures and writes them; leaves nothing behind if the task is cancelled or fails. */
    static void write(
            Studio studio, Animation animation, Path file, AnimationFormat format, boolean captioned, Progress progress)
            throws Exception {
        int frames = animation.frames();
        ToneCurve curve = studio.settings().toneCurve();
        try (PhotographTaker taker = new PhotographTaker();
                AnimationWriter writer = format.open(file, Animation.FRAME_RATE)) {
            for (int i = 0; i < frames; i++) {
                Studio moment = animation.studio(studio, animation.timeOf(i));
                PhotographInfo info = SelfDescription.of(moment);
                LinearImage image = taker.take(moment, progress, (double) i / frames, 1.0 / frames);
                BufferedImage picture = BufferedImages.toBufferedImage(image, curve);
                if (captioned) {
                    PictureLabel.paint(picture, Captions.of(moment, animation.property()));
                }
                writer.add(picture, info);
            }
            writer.finish();
        }
    }
}
