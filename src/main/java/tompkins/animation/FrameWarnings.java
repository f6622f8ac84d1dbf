package tompkins.animation;

import java.util.ArrayList;
import java.util.List;

/**
 * What the user should know about the photographs of an animation: all warnings of the first that has some, and how
 * many others have any.
 */
public final class FrameWarnings {

    private final int frames;
    private final List<String> sentences = new ArrayList<>();
    private int others;

    /**
     * No warnings yet.
     *
     * @param frames number of photographs
     */
    FrameWarnings(int frames) {
        this.frames = frames;
    }

    /** Adds the warnings of a photograph, which is numbered from 0. */
    void add(int number, List<String> warnings) {
        if (warnings.isEmpty()) {
            return;
        }
        if (!sentences.isEmpty()) {
            others++;
            return;
        }
        warnings.forEach(warning -> sentences.add("frame " + number + " of 0-" + (frames - 1) + ": " + warning));
    }

    /** One sentence for each; empty if all is well. */
    public List<String> sentences() {
        List<String> all = new ArrayList<>(sentences);
        if (others > 0) {
            all.add("there are warnings about " + others + (others == 1 ? " other frame" : " other frames")
                    + ", too; render a single one to read them");
        }
        return all;
    }
}
