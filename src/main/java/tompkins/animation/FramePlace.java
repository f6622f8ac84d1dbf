package tompkins.animation;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a frame of a film says about itself besides its scene, so that frames from several machines can be put together.
 *
 * @param frame its number, counted from 0
 * @param frames the number of frames in the film
 * @param frameRate the frames in a second
 * @param caption what is written into it; may be empty
 */
public record FramePlace(int frame, int frames, int frameRate, String caption) {

    private static final Pattern TEXT =
            Pattern.compile("frame ([0-9]{1,9}) of 0-([0-9]{1,8}), ([0-9]{1,4}) a second(?:: (.*))?");

    /** Reads what {@link #toString} writes; empty for anything else. */
    static Optional<FramePlace> parse(String text) {
        Matcher place = TEXT.matcher(text);
        return place.matches()
                ? Optional.of(new FramePlace(
                        Integer.parseInt(place.group(1)),
                        1 + Integer.parseInt(place.group(2)),
                        Integer.parseInt(place.group(3)),
                        place.group(4) == null ? "" : place.group(4)))
                : Optional.empty();
    }

    /** Whether a frame belongs to the same film and has a number. */
    boolean isBeside(FramePlace other, int number) {
        return frame == number && frames == other.frames && frameRate == other.frameRate;
    }

    @Override
    public String toString() {
        return "frame " + frame + " of 0-" + (frames - 1) + ", " + frameRate + " a second"
                + (caption.isEmpty() ? "" : ": " + caption);
    }
}
