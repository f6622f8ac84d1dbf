package tompkins.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Pattern;
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
                    + (corners.length == 1 ? "" : ", or two such pairs as in 10,20..30,40") + ", was "
                    + OptionValues.shown(pixel));
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

    /**
     * The pixels, each as its column and its row, in the order of the options, row by row. Each comes when it is asked
     * for: an iterator of a stream that is flattened would hold all of a rectangle.
     */
    Stream<int[]> stream() {
        return Stream.iterate(first(0), Objects::nonNull, this::next).map(place -> new int[] {place[1], place[2]});
    }

    /** The first place in a rectangle: its number, column and row; null behind the last rectangle. */
    private int[] first(int rectangle) {
        if (rectangle == rectangles.size()) {
            return null;
        }
        int[] corners = rectangles.get(rectangle);
        return new int[] {rectangle, corners[0], corners[1]};
    }

    private int[] next(int[] place) {
        int[] corners = rectangles.get(place[0]);
        if (place[1] + every <= corners[2]) {
            return new int[] {place[0], place[1] + every, place[2]};
        }
        return place[2] + every <= corners[3]
                ? new int[] {place[0], corners[0], place[2] + every}
                : first(place[0] + 1);
    }
}
