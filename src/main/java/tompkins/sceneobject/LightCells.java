package tompkins.sceneobject;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.joml.Vector3dc;
import tompkins.sceneobject.LampView.Cells;

/** Puts the primitives of a scene into the cells of the view of a lamp. */
final class LightCells {

    /**
     * With more primitives than this in the mean cell of a small grid, or cells for a primitive, the tree is faster.
     */
    private static final int MOST_IN_MEAN = 24;

    private static final int CELLS_OF_SMALL_GRID = 128 * 128;

    /**
     * In a large grid, fewer cells than this for a primitive gain nothing: each ray finds others in its cell than its
     * neighbour did, and the tree is as fast.
     */
    private static final int LEAST_IN_MEAN = 3;

    /** A rectangle of so few cells is taken as it is; a larger one may be empty but for a diagonal. */
    private static final int SMALL_RECTANGLE = 16;

    /** Rows that are filled together, while another thread fills others. */
    private static final int ROWS = 16;

    private final LampView view;

    /** The nearest first, with the rectangles of cells in which they are seen. */
    private final Occluder[] occluders;

    private final Cells[] rectangles;
    private final long most;
    private final AtomicLong entries = new AtomicLong();
    private final Occluder[][] cells;
    private final int[] counts;

    private LightCells(LampView view, Occluder[] occluders, Cells[] rectangles, long most) {
        this.view = view;
        this.occluders = occluders;
        this.rectangles = rectangles;
        this.most = most;
        cells = new Occluder[view.side() * view.side()][];
        counts = new int[cells.length];
    }

    /**
     * For each cell of a view what is seen there, the nearest first, or null if nothing is.
     *
     * @return null if the primitives are seen in too many cells, or many primitives in too few
     */
    static Occluder[][] of(Vector3dc lamp, LampView view, List<Primitive> primitives) {
        long most = (long) MOST_IN_MEAN * Math.max(CELLS_OF_SMALL_GRID, primitives.size());
        Cells[] rectangles = primitives.parallelStream()
                .map(primitive -> view.cells(primitive.bounds()))
                .toArray(Cells[]::new);
        long area = Arrays.stream(rectangles)
                .mapToLong(rectangle -> (long) rectangle.width() * rectangle.height())
                .sum();
        if (view.side() * view.side() > CELLS_OF_SMALL_GRID && area < (long) LEAST_IN_MEAN * rectangles.length) {
            return null;
        }
        // what crosses a rectangle is seen in each column or in each row of it
        long least = Arrays.stream(rectangles)
                .mapToLong(rectangle -> Math.max(rectangle.width(), rectangle.height()))
                .sum();
        if (least > most) {
            return null;
        }
        Occluder[] occluders = primitives.parallelStream()
                .map(primitive -> new Occluder(primitive, lamp))
                .toArray(Occluder[]::new);
        int[] order = nearestFirst(occluders);
        LightCells filled = new LightCells(
                view,
                Arrays.stream(order).mapToObj(i -> occluders[i]).toArray(Occluder[]::new),
                Arrays.stream(order).mapToObj(i -> rectangles[i]).toArray(Cells[]::new),
                most);
        IntStream.range(0, view.side() / ROWS).parallel().forEach(band -> filled.fillRows(band * ROWS));
        return filled.entries.get() <= most ? filled.cells : null;
    }

    /** Places in the order of distance; numbers are sorted many times as fast as objects. */
    private static int[] nearestFirst(Occluder[] occluders) {
        long[] keys = new long[occluders.length];
        Arrays.setAll(keys, i -> (long) Float.floatToIntBits(occluders[i].leastDistance()) << Integer.SIZE | i);
        Arrays.parallelSort(keys);
        return Arrays.stream(keys).mapToInt(key -> (int) key).toArray();
    }

    private void fillRows(int from) {
        for (int i = 0; i < occluders.length && entries.get() <= most; i++) {
            Cells rectangle = rectangles[i];
            int first = Math.max(from, rectangle.firstRow());
            int last = Math.min(from + ROWS - 1, rectangle.lastRow());
            if (first > last) {
                continue;
            }
            if (rectangle.width() * rectangle.height() <= SMALL_RECTANGLE) {
                for (int row = first; row <= last; row++) {
                    for (int column = rectangle.firstColumn(); column <= rectangle.lastColumn(); column++) {
                        add(i, column, row);
                    }
                }
                entries.addAndGet((long) rectangle.width() * (last - first + 1));
            } else {
                for (int column = 0; column < view.side(); column += ROWS) {
                    entries.addAndGet(fillSquare(i, column, from, ROWS));
                }
            }
        }
        for (int cell = from * view.side(); cell < (from + ROWS) * view.side(); cell++) {
            if (cells[cell] != null) {
                cells[cell] = Arrays.copyOf(cells[cell], counts[cell]);
            }
        }
    }

    /** Hands a primitive down to the quarters of a square of cells that it can be seen in; to how many cells. */
    private int fillSquare(int occluder, int column, int row, int size) {
        if (!rectangles[occluder].overlaps(column, row, size)
                || !view.isSeen(occluders[occluder].primitive(), column, row, size)) {
            return 0;
        }
        if (size == 1) {
            add(occluder, column, row);
            return 1;
        }
        int half = size / 2;
        return fillSquare(occluder, column, row, half)
                + fillSquare(occluder, column + half, row, half)
                + fillSquare(occluder, column, row + half, half)
                + fillSquare(occluder, column + half, row + half, half);
    }

    private void add(int occluder, int column, int row) {
        int cell = row * view.side() + column;
        int count = counts[cell]++;
        if (count == 0) {
            cells[cell] = new Occluder[4];
        } else if (count == cells[cell].length) {
            cells[cell] = Arrays.copyOf(cells[cell], 2 * count);
        }
        cells[cell][count] = occluders[occluder];
    }
}
