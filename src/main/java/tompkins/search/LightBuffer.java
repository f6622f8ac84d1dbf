package tompkins.search;

import java.util.Arrays;
import java.util.List;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.search.LightBufferProjection.Rectangle;

/** What lies in the cells of a lamp's view, the nearest first. All cells lie one after the other in arrays. */
final class LightBuffer {

    /** With more primitives than this in the average cell the tree needs less memory and less time to build. */
    private static final int MOST_IN_MEAN = 48;

    /** If there are many primitives, each may be seen in this many cells on average. */
    private static final int MOST_CELLS_OF_MANY = 8;

    /** With this many primitives in the cell of the average primitive there are too many, wherever the others are. */
    private static final int MOST_IN_CROWD = 1000;

    private static final int PARTS = LightBufferProjection.PARTS;
    private static final int CELLS = LightBufferProjection.SIDE * LightBufferProjection.SIDE;

    /** Where each cell begins; the last one ends at the last number. */
    private final int[] starts;

    private final long[] entries;
    private final Primitive[] primitives;

    private LightBuffer(int[] starts) {
        this.starts = starts;
        entries = new long[starts[CELLS]];
        primitives = new Primitive[starts[CELLS]];
    }

    /**
     * A primitive as a lamp sees it.
     *
     * @param leastDistance a lower bound of its distance from the lamp; 0 or more
     * @param rectangle where it is seen
     * @param strip the same, if it is long; otherwise null
     */
    private record ProjectedBounds(
            Primitive primitive, float leastDistance, Rectangle rectangle, LightBufferProjection.Strip strip) {

        static ProjectedBounds of(Primitive primitive, LightBufferProjection view) {
            Bounds box = primitive.bounds().widened();
            return new ProjectedBounds(
                    primitive, view.leastDistance(box), view.rectangle(primitive, box), view.strip(primitive, box));
        }

        /** Where it is seen in some rows of a column of cells, or more; empty if it is not. */
        Rectangle rectangle(LightBufferProjection view, int column, int row, int rows) {
            return strip == null ? rectangle : rectangle.and(view.rectangle(strip, column, row, rows));
        }
    }

    /** Does something with each cell of a view in which a primitive is seen, and with its entry there. */
    private interface CellVisitor {
        void visit(int cell, long entry);
    }

    /** The cells of a view, or null if the primitives are seen in too many of them, or too many in one. */
    static LightBuffer of(LightBufferProjection view, List<Primitive> primitives) {
        long most = Math.max((long) MOST_IN_MEAN * CELLS, (long) MOST_CELLS_OF_MANY * primitives.size());
        ProjectedBounds[] nearestFirst = nearestFirst(primitives.parallelStream()
                .map(primitive -> ProjectedBounds.of(primitive, view))
                .toArray(ProjectedBounds[]::new));
        int[] starts = new int[CELLS + 1];
        long left = most;
        for (int i = 0; i < nearestFirst.length && left >= 0; i++) {
            left -= visit(view, nearestFirst[i], (cell, entry) -> starts[cell + 1]++);
        }
        if (left < 0 || isCrowded(starts)) {
            return null;
        }
        Arrays.parallelPrefix(starts, Integer::sum);
        LightBuffer buffer = new LightBuffer(starts);
        int[] next = starts.clone();
        for (ProjectedBounds sight : nearestFirst) {
            visit(view, sight, (cell, entry) -> {
                buffer.entries[next[cell]] = entry;
                buffer.primitives[next[cell]++] = sight.primitive();
            });
        }
        return buffer;
    }

    /** Visits the cells in which a primitive is seen, and returns how many they are. */
    private static int visit(LightBufferProjection view, ProjectedBounds sight, CellVisitor visitor) {
        int count = 0;
        Rectangle all = sight.rectangle();
        for (int column = all.firstColumn() / PARTS; column <= all.lastColumn() / PARTS; column++) {
            Rectangle inColumn = sight.rectangle(view, column, 0, LightBufferProjection.SIDE);
            for (int row = inColumn.firstRow() / PARTS; row <= inColumn.lastRow() / PARTS; row++) {
                Rectangle inCell = sight.rectangle(view, column, row, 1);
                if (!inCell.isEmpty()) {
                    visitor.visit(
                            row * LightBufferProjection.SIDE + column,
                            BufferEntry.of(sight.leastDistance(), inCell, column, row));
                    count++;
                }
            }
        }
        return count;
    }

    /** Sorts numbers, which is many times as fast as sorting objects. */
    private static ProjectedBounds[] nearestFirst(ProjectedBounds[] sights) {
        long[] keys = new long[sights.length];
        Arrays.setAll(keys, i -> (long) Float.floatToIntBits(sights[i].leastDistance()) << Integer.SIZE | i);
        Arrays.parallelSort(keys);
        return Arrays.stream(keys).mapToObj(key -> sights[(int) key]).toArray(ProjectedBounds[]::new);
    }

    private static boolean isCrowded(int[] counts) {
        double sum = 0;
        double squares = 0;
        for (double count : counts) {
            sum += count;
            squares += count * count;
        }
        return squares > MOST_IN_CROWD * sum;
    }

    /** Index of the first entry of a cell. */
    int first(int cell) {
        return starts[cell];
    }

    /** Index after the last entry of a cell. */
    int end(int cell) {
        return starts[cell + 1];
    }

    /** The entry at an index. */
    long entry(int index) {
        return entries[index];
    }

    /** The primitive of the entry at an index. */
    Primitive primitive(int index) {
        return primitives[index];
    }
}
