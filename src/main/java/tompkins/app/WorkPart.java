package tompkins.app;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * One of several equal parts of some work. Its pieces are not neighbours: where the cost grows from piece to piece, all
 * parts still take about the same time.
 *
 * @param index which part, from 0
 * @param count the number of parts
 */
record WorkPart(int index, int count) {

    private static final Pattern WRITTEN = Pattern.compile("([0-9]{1,9})/([0-9]{1,9})");

    /** Reads {@code I/N}. */
    static WorkPart parse(String text) {
        Matcher numbers = WRITTEN.matcher(text);
        if (numbers.matches()) {
            WorkPart part = new WorkPart(Integer.parseInt(numbers.group(1)), Integer.parseInt(numbers.group(2)));
            if (part.index < part.count) {
                return part;
            }
        }
        throw OptionValues.refused("I/N: the part I of N, counted from 0 and below N, such as 0/4", text);
    }

    /** The pieces of the work that belong to this part: each N-th, beginning with I. */
    <T> List<T> of(List<T> pieces) {
        return IntStream.range(0, pieces.size())
                .filter(i -> i % count == index)
                .mapToObj(pieces::get)
                .toList();
    }
}
