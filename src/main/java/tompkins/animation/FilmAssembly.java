package tompkins.animation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;
import tompkins.file.FileException;
import tompkins.image.AnimationFormat;
import tompkins.image.AnimationWriter;
import tompkins.image.FrameFolder;
import tompkins.image.FramePicture;
import tompkins.property.MistakeException;
import tompkins.render.Progress;

/** Makes one film of the frames in a folder, which may have been taken on several machines. */
public final class FilmAssembly {

    private static final int MOST_FRAMES = (int) (RideFilm.LONGEST * AnimationFormat.FASTEST) + 1;

    private final FrameFolder folder;
    private final Optional<FramePlace> place;
    private final int count;
    private final List<Integer> missing;

    /**
     * Looks at the frames of a folder.
     *
     * @throws MistakeException if there are none, they belong to several films, or to one that is too long
     * @throws FileException if the folder cannot be read
     */
    public FilmAssembly(FrameFolder folder) throws FileException {
        this.folder = folder;
        SortedSet<Integer> whole = new TreeSet<>(folder.frames());
        whole.removeIf(frame -> !folder.isWhole(frame));
        if (whole.isEmpty()) {
            throw new MistakeException(folder.folder() + ": holds no frames of a film, "
                    + folder.file(0).getFileName() + " and so on");
        }
        place = place(whole.first());
        for (int frame : whole) {
            requirePlace(frame);
        }
        count = place.map(FramePlace::frames).orElse(whole.last() + 1);
        if (count > MOST_FRAMES) {
            throw new MistakeException(folder.file(whole.last()) + ": is a frame of a film of " + count
                    + " frames; a film has at most " + MOST_FRAMES);
        }
        missing = IntStream.range(0, count)
                .filter(frame -> !whole.contains(frame))
                .boxed()
                .toList();
    }

    private Optional<FramePlace> place(int frame) throws FileException {
        return FramePlace.parse(folder.info(frame).description());
    }

    private void requirePlace(int frame) throws FileException {
        Optional<FramePlace> own = place(frame);
        if (own.isPresent() != place.isPresent()
                || own.isPresent() && !own.get().isBeside(place.get(), frame)) {
            throw new MistakeException(folder.file(frame) + ": belongs to another film than the frames before it: "
                    + own.map(FramePlace::toString).orElse("it does not say to which"));
        }
    }

    /** The number of frames in the film. Where frames do not say it, the last that is there is the last of the film. */
    public int count() {
        return count;
    }

    /** The frames in a second; empty if the frames do not say it. */
    public OptionalInt frameRate() {
        return place.map(known -> OptionalInt.of(known.frameRate())).orElse(OptionalInt.empty());
    }

    /**
     * The numbers of the frames that are not there, or are damaged, such as {@code 3,5-8,10-90x10}; empty if all are.
     */
    public String missing() {
        return text(missing);
    }

    /** Numbers in order, as short as ranges make them. */
    static String text(List<Integer> frames) {
        List<String> parts = new ArrayList<>();
        for (int i = 0; i < frames.size(); ) {
            int step = i + 1 < frames.size() ? frames.get(i + 1) - frames.get(i) : 1;
            int end = i;
            while (end + 1 < frames.size() && frames.get(end + 1) - frames.get(end) == step) {
                end++;
            }
            boolean isRange = end > i + 1 || end == i + 1 && step == 1;
            parts.add(
                    isRange
                            ? frames.get(i) + "-" + frames.get(end) + (step == 1 ? "" : "x" + step)
                            : frames.get(i).toString());
            i = isRange ? end + 1 : i + 1;
        }
        return String.join(",", parts);
    }

    /**
     * Adds all frames to a file, but does not complete the file. The film is the same as one that was taken at once.
     *
     * @throws MistakeException if the frames differ in size
     * @throws FileException if a frame cannot be read, or the file not be written
     */
    public void write(AnimationWriter writer, Progress progress) throws FileException {
        FramePicture first = folder.picture(0);
        for (int frame = 0; frame < count; frame++) {
            FramePicture picture = folder.picture(frame);
            if (!picture.size().equals(first.size())) {
                throw new MistakeException(folder.file(frame) + ": must have the size of the first frame, "
                        + first.size() + ", was " + picture.size());
            }
            writer.add(picture.image());
            progress.setProgress((frame + 1.0) / count);
        }
    }
}
