package tompkins.search;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import tompkins.search.LightBufferProjection.Rectangle;

/**
 * Notes in which cells of a lamp's view some primitives are seen. For one thread, while other threads note other
 * primitives.
 */
final class LightBufferBuilder {

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
            ProjectedBounds sight = sights[number];
            Rectangle all = sight.rectangle();
            for (int column = all.firstCellColumn(); column <= all.lastCellColumn(); column++) {
                Rectangle inColumn = sight.rectangle(view, column, 0, LightBufferProjection.SIDE);
                for (int row = inColumn.firstCellRow(); row <= inColumn.lastCellRow(); row++) {
                    Rectangle inCell = sight.rectangle(view, column, row, 1);
                    if (!inCell.isEmpty()) {
                        noteCell(number, column, row, BufferEntry.of(sight.leastDistance(), inCell, column, row));
                    }
                }
            }
            left.addAndGet(before - count);
        }
    }

    private void noteCell(int number, int column, int row, long entry) {
        if (count == cells.length) {
            cells = Arrays.copyOf(cells, 2 * count);
            numbers = Arrays.copyOf(numbers, 2 * count);
            entries = Arrays.copyOf(entries, 2 * count);
        }
        cells[count] = row * LightBufferProjection.SIDE + column;
        numbers[count] = number;
        entries[count] = entry;
        count++;
    }

    /** Number of entries. */
    int count() {
        return count;
    }

    /** The cell of an entry, row by row. */
    int cell(int index) {
        return cells[index];
    }

    /** The number of the primitive to which an entry belongs. */
    int number(int index) {
        return numbers[index];
    }

    /** An entry. */
    long entry(int index) {
        return entries[index];
    }
}
