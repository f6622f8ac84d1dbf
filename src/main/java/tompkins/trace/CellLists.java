package tompkins.trace;

import java.util.function.IntConsumer;

/** Numbers from 0 on, each in some cells; those of a cell lie together in memory. Immutable. */
final class CellLists {

    /** The numbers in each cell, one cell after the other. */
    private final int[] numbers;

    /** Where those of each cell begin. */
    private final int[] begins;

    /** Says in which cells a number lies: the same ones each time. */
    interface Places {
        void forEachCell(int number, IntConsumer cell);
    }

    /** The numbers below a limit, in so many cells. */
    CellLists(int cells, int limit, Places places) {
        begins = new int[cells + 1];
        for (int number = 0; number < limit; number++) {
            places.forEachCell(number, cell -> begins[cell + 1]++);
        }
        for (int cell = 0; cell < cells; cell++) {
            begins[cell + 1] += begins[cell];
        }
        numbers = new int[begins[cells]];
        int[] next = begins.clone();
        for (int i = 0; i < limit; i++) {
            int number = i;
            places.forEachCell(number, cell -> numbers[next[cell]++] = number);
        }
    }

    /** The index at which the numbers of a cell begin. */
    int begin(int cell) {
        return begins[cell];
    }

    /** The index behind the last number of a cell. */
    int end(int cell) {
        return begins[cell + 1];
    }

    /** The number at an index. */
    int number(int index) {
        return numbers[index];
    }
}
