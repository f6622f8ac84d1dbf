package tompkins.search;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import tompkins.primitive.Primitive;

/** What lies in the cells of a lamp's view, the nearest first. All cells lie one after the other in arrays. */
final class LightBuffer {

    /** With more primitives than this in the average cell the tree needs less memory and less time to build. */
    private static final int MOST_IN_MEAN = 48;

    /** If there are many primitives, each may be seen in this many cells on average. */
    private static final int MOST_CELLS_OF_MANY = 8;

    /** With this many primitives in the cell of the average primitive there are too many, wherever the others are. */
    private static final int MOST_IN_CROWD = 1000;

    /** Number of primitives that are noted at once, while another thread notes others. */
    private static final int CHUNK = 4096;

    private static final int CELLS = LightBufferProjection.SIDE * LightBufferProjection.SIDE;

    /** Where each cell begins; the last one ends at the last number. */
    private final int[] starts;

    private final long[] entries;
    private final Primitive[] primitives;

    /** Moves each entry to its cell, where the entries keep their order. */
    private LightBuffer(int[] starts, List<LightBufferBuilder> notes, ProjectedBounds[] sights) {
        this.starts = starts;
        entries = new long[starts[CELLS]];
        primitives = new Primitive[starts[CELLS]];
        int[] next = starts.clone();
        for (LightBufferBuilder part : notes) {
            for (int i = 0; i < part.count(); i++) {
                int index = next[part.cell(i)]++;
                entries[index] = part.entry(i);
                primitives[index] = sights[part.number(i)].primitive();
            }
        }
    }

    /** The cells of a view, or null if the primitives are seen in too many of them, or too many in one. */
    static LightBuffer of(LightBufferProjection view, List<Primitive> primitives) {
        long most = Math.max((long) MOST_IN_MEAN * CELLS, (long) MOST_CELLS_OF_MANY * primitives.size());
        ProjectedBounds[] sights = primitives.parallelStream()
                .map(primitive -> ProjectedBounds.of(primitive, view))
                .toArray(ProjectedBounds[]::new);
        // what crosses a rectangle is seen in each of its columns or in each of its rows
        long least = Arrays.stream(sights)
                .map(ProjectedBounds::rectangle)
                .mapToLong(rectangle -> Math.max(rectangle.width(), rectangle.height()))
                .sum();
        if (least > most) {
            return null;
        }
        ProjectedBounds[] nearestFirst = nearestFirst(sights);
        AtomicLong left = new AtomicLong(most);
        List<LightBufferBuilder> notes = IntStream.range(0, (nearestFirst.length + CHUNK - 1) / CHUNK)
                .parallel()
                .mapToObj(chunk -> notes(view, nearestFirst, chunk * CHUNK, left))
                .toList();
        int[] starts = starts(notes);
        return left.get() < 0 || isCrowded(starts) ? null : new LightBuffer(starts, notes, nearestFirst);
    }

    private static LightBufferBuilder notes(
            LightBufferProjection view, ProjectedBounds[] sights, int from, AtomicLong left) {
        LightBufferBuilder notes = new LightBufferBuilder(view, sights);
        notes.note(from, Math.min(from + CHUNK, sights.length), left);
        return notes;
    }

    /** Sorts numbers, which is many times as fast as sorting objects. */
    private static ProjectedBounds[] nearestFirst(ProjectedBounds[] sights) {
        long[] keys = new long[sights.length];
        Arrays.setAll(keys, i -> (long) Float.floatToIntBits(sights[i].leastDistance()) << Integer.SIZE | i);
        Arrays.parallelSort(keys);
        return Arrays.stream(keys).mapToObj(key -> sights[(int) key]).toArray(ProjectedBounds[]::new);
    }

    private static int[] starts(List<LightBufferBuilder> notes) {
        int[] starts = new int[CELLS + 1];
        for (LightBufferBuilder part : notes) {
            for (int i = 0; i < part.count(); i++) {
                starts[part.cell(i) + 1]++;
            }
        }
        Arrays.parallelPrefix(starts, Integer::sum);
        return starts;
    }

    private static boolean isCrowded(int[] starts) {
        double squares = 0;
        for (int cell = 0; cell < CELLS; cell++) {
            double count = starts[cell + 1] - starts[cell];
            squares += count * count;
        }
        return squares > (double) MOST_IN_CROWD * starts[CELLS];
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
