package tompkins.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.property.MistakeException;
import tompkins.studio.RenderSettings;

/** The pixels that were chosen by {@code --pixel}: single ones, rectangles of them, or all. */
final class PixelChoice {

    private static final String ALL = "all";
    private static final Pattern CORNER = Pattern.compile(" *-?[0-9]{1,9} *, *-?[0-9]{1,9} *");

    /** Rectangles: first column and row, last column and row. */
    private final List<int[]> rectangles = new ArrayList<>();

    private final int every;

    private PixelChoice(int every) {
        this.every = every;
    }

    /**
     * The choice that options name.
     *
     * @param pixels each {@code X,Y}, {@code X,Y..X,Y} or {@code all}
     * @param every the step from one column or row of a rectangle to the next that is taken, 1 or more
     */
    static PixelChoice of(List<String> pixels, long every, RenderSettings settings) {
        if (every < 1) {
            throw new MistakeException("--every must be 1 or more, was " + every);
        }
        PixelChoice choice = new PixelChoice((int) Math.min(every, RenderSettings.LONGEST_SIDE));
        for (String pixel : pixels) {
            int[] rectangle = rectangle(pixel, settings);
            requireInside(rectangle[0], rectangle[1], settings);
            requireInside(rectangle[2], rectangle[3], settings);
            if (rectangle[2] < rectangle[0] || rectangle[3] < rectangle[1]) {
                throw new MistakeException(
                        "--pixel must name the upper left corner of a rectangle first, was " + pixel);
            }
            choice.rectangles.add(rectangle);
        }
        return choice;
    }

    private static int[] rectangle(String pixel, RenderSettings settings) {
        if (pixel.equals(ALL)) {
            return new int[] {0, 0, settings.width() - 1, settings.height() - 1};
        }
        String[] corners = pixel.split("\\.\\.", 2);
        if (!Stream.of(corners).allMatch(corner -> CORNER.matcher(corner).matches())) {
            throw new MistakeException("--pixel must be two whole numbers inside the picture with a comma between them"
                    + (corners.length == 1 ? "" : ", or two such pairs as in 10,20..30,40") + ", was " + pixel);
        }
        String both = pixel.contains("..") ? pixel : pixel + ".." + pixel;
        return Stream.of(both.split(",|\\.\\."))
                .mapToInt(number -> Integer.parseInt(number.strip()))
                .toArray();
    }

    private static void requireInside(int column, int row, RenderSettings settings) {
        int right = settings.width() - 1;
        int bottom = settings.height() - 1;
        if (column < 0 || row < 0 || column > right || row > bottom) {
            throw new MistakeException(String.format(
                    Locale.ROOT, "--pixel must be from 0,0 to %d,%d, was %d,%d", right, bottom, column, row));
        }
    }

    /** Whether it is one pixel. */
    boolean isSingle() {
        return stream().limit(2).count() == 1;
    }

    /** The pixels, each as its column and its row, in the order of the options, row by row. */
    Stream<int[]> stream() {
        return rectangles.stream()
                .flatMap(corners -> steps(corners[1], corners[3])
                        .boxed()
                        .flatMap(row -> steps(corners[0], corners[2]).mapToObj(column -> new int[] {column, row})));
    }

    private IntStream steps(int first, int last) {
        return IntStream.iterate(first, place -> place <= last, place -> place + every);
    }
}
