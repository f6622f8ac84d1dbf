package tompkins.search;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import tompkins.search.LightBufferProjection.Rectangle;

/**
 * Notes in which cells of a lamp's view some primitives are seen. For one thread, while other threads note other
 * primitives.
 */
final class LightBufferBuilder {

    /** A rectangle of at most this many cells is taken whole; a larger one may be empty except for a diagonal. */
    private static final int SMALL_RECTANGLE = 16;

    private final LightBufferProjection view;
    private final ProjectedBounds[] sights;

    // one behind the other
    private int count;
    private int[] cells = new int[1 << 10];
    private int[] numbers = new int[1 << 10];
    private long[] entries = new long[1 << 10];

    /** Notes for the view of a lamp. */
    LightBufferBuilder(LightBufferProjection view, ProjectedBounds[] sights) {
        this.view = view;
        this.sights = sights;
    }

    /**
     * Notes some primitives, in their order.
     *
     * @param from number of the first
     * @param to number behind the last
     * @param left number of entries that may still be noted, here and by others; gives up when it falls below 0
     */
    void note(int from, int to, AtomicLong left) {
        for (int number = from; number < to && left.get() >= 0; number++) {
            int before = count;
            Rectangle rectangle = sights[number].rectangle();
            if (sights[number].strip() != null) {
                noteStrip(number);
            } else if (rectangle.width() * rectangle.height() <= SMALL_RECTANGLE) {
                for (int column = rectangle.firstCellColumn(); column <= rectangle.lastCellColumn(); column++) {
                    noteColumn(number, column, rectangle);
                }
            } else {
                noteSquare(number, 0, 0, LightBufferProjection.SIDE);
            }
            left.addAndGet(before - count);
        }
    }

    private void noteStrip(int number) {
        Rectangle all = sights[number].rectangle();
        for (int column = all.firstCellColumn(); column <= all.lastCellColumn(); column++) {
            noteColumn(
                    number,
                    column,
                    all.and(view.rectangle(sights[number].strip(), column, 0, LightBufferProjection.SIDE)));
        }
    }

    /** Notes those cells of a column that a rectangle reaches into. */
    private void noteColumn(int number, int column, Rectangle rectangle) {
        for (int row = rectangle.firstCellRow(); row <= rectangle.lastCellRow(); row++) {
            noteCell(number, column, row);
        }
    }

    /** Hands a primitive down to the quarters of a square of cells that it can be seen in. */
    private void noteSquare(int number, int column, int row, int size) {
        ProjectedBounds sight = sights[number];
        if (!sight.rectangle().overlaps(column, row, size) || !view.isSeen(sight.primitive(), column, row, size)) {
            return;
        }
        if (size == 1) {
            noteCell(number, column, row);
            return;
        }
        int half = size / 2;
        // one call, because Java makes one piece of code of this method and of those that it calls here
        for (int quarter = 0; quarter < 4; quarter++) {
            noteSquare(number, column + quarter % 2 * half, row + quarter / 2 * half, half);
        }
    }

    private void noteCell(int number, int column, int row) {
        ProjectedBounds sight = sights[number];
        Rectangle rectangle = sight.rectangle();
        if (sight.strip() != null) {
            rectangle = rectangle.and(view.rectangle(sight.strip(), column, row, 1));
            if (rectangle.isEmpty()) {
                return;
            }
        }
        if (count == cells.length) {
            cells = Arrays.copyOf(cells, 2 * count);
            numbers = Arrays.copyOf(numbers, 2 * count);
            entries = Arrays.copyOf(entries, 2 * count);
        }
        cells[count] = row * LightBufferProjection.SIDE + column;
        numbers[count] = number;
        entries[count] = PackedEntry.of(sight.leastDistance(), rectangle, column, row);
        count++;
    }

    /** Number of entries. */
    int count() {
        return count;
    }

    /** The cell of an entry, row by row. */
    int cell(int place) {
        return cells[place];
    }

    /** The number of the primitive to which an entry belongs. */
    int number(int place) {
        return numbers[place];
    }

    /** An entry. */
    long entry(int place) {
        return entries[place];
    }
}
