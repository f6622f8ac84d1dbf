package tompkins.animation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import tompkins.file.FileException;
import tompkins.image.AnimationWriter;
import tompkins.image.FrameFolder;
import tompkins.image.FramePicture;
import tompkins.image.PhotographInfo;
import tompkins.image.PictureLabel;
import tompkins.io.SelfDescription;
import tompkins.property.OneLine;
import tompkins.render.PhotographTaker;
import tompkins.render.Progress;
import tompkins.render.RenderJob;
import tompkins.render.RenderReport;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;

/**
 * Takes photographs of a sequence one after the other, each with the quality that the studio asks for. The same frame
 * gives the same bytes, whichever others are taken.
 *
 * @param film the sequence
 * @param caption what is written into each photograph
 * @param decorations what is drawn over the photograph of a studio
 * @param threads number of threads, 1 or more
 */
public record AnimationRecorder(
        FrameSequence film,
        FrameSequence.Caption caption,
        Function<Studio, Consumer<FramePicture>> decorations,
        int threads) {

    /** What a folder has under the name of a frame: nothing or a damaged picture; the same frame; or anything else. */
    public enum Found {
        NOTHING,
        SAME,
        OTHER
    }

    /** Where the photographs go. */
    private interface Store {

        void add(int frame, FramePicture picture, PhotographInfo info) throws FileException;
    }

    /**
     * Takes all photographs and adds them to a file, but does not complete the file.
     *
     * @return what the user should know about the photographs: all warnings of the first that has some, and how many
     *     others have any
     * @throws CancellationException if it is cancelled
     * @throws FileException if the file cannot be written
     */
    public List<String> record(AnimationWriter writer, Progress progress) throws FileException, InterruptedException {
        Store file = (frame, picture, info) -> writer.add(picture.image());
        return record(allFrames(), frame -> false, file, progress);
    }

    /**
     * Takes some of the photographs into a folder, to which other processes may add at the same time; otherwise as the
     * other. The frames before a failure stay.
     *
     * @param skips whether frames are left out that another process has meanwhile taken
     */
    public List<String> record(List<Integer> frames, FrameFolder folder, boolean skips, Progress progress)
            throws FileException, InterruptedException {
        return record(frames, frame -> skips && found(folder, frame) == Found.SAME, folder::write, progress);
    }

    /** The numbers of all photographs. */
    public List<Integer> allFrames() {
        return IntStream.range(0, film.frames()).boxed().toList();
    }

    /** What is in a folder under the name of a frame. */
    public Found found(FrameFolder folder, int frame) {
        if (!folder.isThere(frame)) {
            return Found.NOTHING;
        }
        try {
            PhotographInfo there = folder.info(frame);
            PhotographInfo wanted = info(frame, moment(frame));
            boolean isSame = there.sceneJson().equals(wanted.sceneJson())
                    && there.description().equals(wanted.description());
            return !isSame ? Found.OTHER : folder.isWhole(frame) ? Found.SAME : Found.NOTHING;
        } catch (FileException notAFrame) {
            return Found.OTHER;
        }
    }

    private List<String> record(List<Integer> frames, IntPredicate isThere, Store store, Progress progress)
            throws FileException, InterruptedException {
        List<String> warnings = new ArrayList<>();
        int warned = 0;
        int count = frames.size();
        try (PhotographTaker taker = new PhotographTaker(threads)) {
            for (int i = 0; i < count; i++) {
                int frame = frames.get(i);
                if (isThere.test(frame)) {
                    continue;
                }
                Studio moment = moment(frame);
                RenderJob photograph = taker.take(moment, progress, (double) i / count, 1.0 / count);
                store.add(frame, painted(photograph, moment, frame), info(frame, moment));
                RenderReport report = photograph.report();
                if (warnings.isEmpty()) {
                    String place = "frame " + frame + " of 0-" + (film.frames() - 1) + ": ";
                    report.warnings().forEach(warning -> warnings.add(place + warning));
                }
                warned += report.warnings().isEmpty() ? 0 : 1;
            }
        }
        if (warned > 1) {
            warnings.add("there are warnings about " + (warned - 1) + (warned == 2 ? " other frame" : " other frames")
                    + ", too; render a single one to read them");
        }
        return warnings;
    }

    /** The seed of a frame is that of the scene, larger by its number. */
    private Studio moment(int frame) {
        Studio studio = film.studio(frame);
        RenderSettings settings = studio.settings();
        return studio.withSettings(settings.withSeed(settings.seed() + frame));
    }

    private FramePicture painted(RenderJob photograph, Studio moment, int frame) {
        FramePicture picture =
                FramePicture.of(photograph.image(), moment.settings().toneCurve());
        decorations.apply(moment).accept(picture);
        String words = caption.of(moment, frame);
        if (!words.isEmpty()) {
            PictureLabel.paint(picture.image(), words);
        }
        return picture;
    }

    private PhotographInfo info(int frame, Studio moment) {
        String words = OneLine.of(caption.of(moment, frame));
        FramePlace place = new FramePlace(frame, film.frames(), film.frameRate(), words);
        return SelfDescription.of(moment).withDescription(place.toString());
    }
}
