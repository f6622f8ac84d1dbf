package tompkins.animation;

import java.util.concurrent.CancellationException;
import java.util.function.Function;
import tompkins.image.AnimationWriter;
import tompkins.image.FileException;
import tompkins.image.PictureDecoration;
import tompkins.image.ToneCurve;
import tompkins.io.SelfDescription;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.render.RenderJob;
import tompkins.studio.Studio;

/** Takes the photographs of a film one after the other, each with the quality that the studio asks for. */
public final class AnimationRecorder {

    private AnimationRecorder() {}

    /**
     * Takes all photographs and adds them to a file, but does not complete the file.
     *
     * @param caption what is written into each photograph
     * @param decorations what is drawn over the photograph of a studio
     * @return what the user should know about the photographs
     * @throws CancellationException if it is cancelled
     * @throws FileException if the file cannot be written
     */
    public static FrameWarnings record(
            Film film,
            AnimationWriter writer,
            Film.Caption caption,
            Function<Studio, PictureDecoration> decorations,
            Progress progress)
            throws FileException, InterruptedException {
        int frames = film.frames();
        FrameWarnings warnings = new FrameWarnings(frames);
        try (PhotographTaker taker = new PhotographTaker()) {
            for (int i = 0; i < frames; i++) {
                Studio moment = film.studio(i);
                RenderJob photograph = taker.take(moment, progress, (double) i / frames, 1.0 / frames);
                ToneCurve curve = moment.settings().toneCurve();
                writer.add(
                        photograph.image(),
                        curve,
                        decorations.apply(moment),
                        caption.of(moment, i),
                        SelfDescription.of(moment));
                warnings.add(i + 1, photograph.report().warnings());
            }
        }
        return warnings;
    }
}
