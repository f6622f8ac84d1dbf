package tompkins.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Option;
import tompkins.animation.AnimationRecorder;
import tompkins.animation.FrameSelection;
import tompkins.image.FrameFolder;
import tompkins.property.MistakeException;

/** Options that take some frames of a film. */
final class FrameOptions extends ManyPictures {

    @Option(
            names = "--frames",
            paramLabel = "LIST",
            description = "take only some frames, counted from 0, such as 3,5-8 or 0-99x10, into a folder")
    private String list;

    /** Whether one was given, so that frames go one by one into a folder. */
    boolean areGiven() {
        return list != null || hasPart() || skips();
    }

    /** The frames that are chosen from a film of so many. */
    FrameSelection choose(int count) {
        FrameSelection chosen = list == null
                ? FrameSelection.all(count)
                : MistakeException.inOption("--frames", () -> FrameSelection.parse(list, count));
        return new FrameSelection(own(chosen.frames()));
    }

    /** The frames that are still to be taken; refuses what is in their place, unless it is replaced. */
    FrameSelection left(FrameSelection chosen, AnimationRecorder recorder, FrameFolder folder) {
        List<Integer> left = new ArrayList<>();
        for (int frame : chosen.frames()) {
            AnimationRecorder.Found found = recorder.found(folder, frame);
            if (found == AnimationRecorder.Found.SAME && skips()) {
                continue;
            }
            if (found != AnimationRecorder.Found.NOTHING && !force()) {
                throw taken(folder.file(frame));
            }
            left.add(frame);
        }
        return new FrameSelection(left);
    }

    private MistakeException taken(Path file) {
        return new MistakeException(file
                + (skips()
                        ? ": is not this frame with these settings; --force replaces it"
                        : ": there is a file of this name already; --force replaces it, --skip-existing leaves it if"
                                + " it is the same frame"));
    }
}
