package tompkins.animation;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import tompkins.property.InvalidPropertyException;

/**
 * Some frames of a film. The film does not change with them: the same frame is the same photograph in any selection.
 *
 * @param frames their numbers, counted from 0, in order
 */
public record FrameSelection(List<Integer> frames) {

    /** A number, or a range of numbers with both ends, or one with a step. */
    private static final Pattern RANGE =
            Pattern.compile("\\s*([0-9]{1,9})\\s*(?:-\\s*([0-9]{1,9})\\s*(?:x\\s*([0-9]{1,9})\\s*)?)?");

    /** Keeps the numbers. */
    public FrameSelection {
        frames = List.copyOf(frames);
    }

    /** All frames of a film. */
    public static FrameSelection all(int count) {
        return new FrameSelection(IntStream.range(0, count).boxed().toList());
    }

    /**
     * The frames that a list names, such as {@code 7}, {@code 0-99}, {@code 0-99x10} (every tenth) or {@code 3,5-8}.
     *
     * @param count the number of frames in the film
     * @throws InvalidPropertyException if this is no list, or the film has no such frames
     */
    public static FrameSelection parse(String list, int count) {
        SortedSet<Integer> frames = new TreeSet<>();
        for (String part : list.split(",", -1)) {
            Matcher range = RANGE.matcher(part);
            if (!range.matches()) {
                throw refused(list, count);
            }
            int first = Integer.parseInt(range.group(1));
            int last = range.group(2) == null ? first : Integer.parseInt(range.group(2));
            int step = range.group(3) == null ? 1 : Integer.parseInt(range.group(3));
            if (first > last || last >= count || step == 0) {
                throw refused(list, count);
            }
            IntStream.rangeClosed(0, (last - first) / step).forEach(i -> frames.add(first + i * step));
        }
        return new FrameSelection(new ArrayList<>(frames));
    }

    private static InvalidPropertyException refused(String list, int count) {
        int last = count - 1;
        return new InvalidPropertyException(
                "frames",
                "numbers from 0 to " + last + " or ranges of them, such as " + last + ", 0-" + last + ", 0-" + last
                        + "x2 or 0,1-" + last,
                list);
    }

    /** The list that names the frames, as short as ranges make it. */
    @Override
    public String toString() {
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
}
