package tompkins.io;

import java.util.Arrays;

/** Whole numbers from -1 upwards that become more. They take no memory as long as all are -1. */
final class IntList {

    private static final int SMALLEST = 64;

    /** Empty as long as all numbers are -1. */
    private int[] numbers = {};

    private int size;

    void add(int number) {
        if (number >= 0 || hasOthers()) {
            if (size >= numbers.length) {
                int[] more = Arrays.copyOf(numbers, Math.max(SMALLEST, 2 * size));
                Arrays.fill(more, numbers.length, more.length, -1);
                numbers = more;
            }
            numbers[size] = number;
        }
        size++;
    }

    int get(int index) {
        return hasOthers() ? numbers[index] : -1;
    }

    /** Whether there is another number than -1. */
    boolean hasOthers() {
        return numbers.length > 0;
    }

    int size() {
        return size;
    }

    int[] toArray() {
        int[] all = Arrays.copyOf(numbers, size);
        if (!hasOthers()) {
            Arrays.fill(all, -1);
        }
        return all;
    }
}
