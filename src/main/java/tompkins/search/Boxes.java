package tompkins.search;

import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/** The bounds of many primitives in one array, without an object for each. */
final class Boxes {

    /** Numbers of a box: the least x, y, z, then the largest. */
    static final int NUMBERS = 6;

    private final double[] values;

    Boxes(Primitive[] primitives) {
        values = new double[Math.multiplyExact(NUMBERS, primitives.length)];
        for (int i = 0; i < primitives.length; i++) {
            Bounds bounds = primitives[i].bounds();
            values[NUMBERS * i] = bounds.minX();
            values[NUMBERS * i + 1] = bounds.minY();
            values[NUMBERS * i + 2] = bounds.minZ();
            values[NUMBERS * i + 3] = bounds.maxX();
            values[NUMBERS * i + 4] = bounds.maxY();
            values[NUMBERS * i + 5] = bounds.maxZ();
        }
    }

    /** Twice the coordinate of a box's centre along an axis (0, 1, 2). */
    double twiceCentre(int box, int axis) {
        return values[NUMBERS * box + axis] + values[NUMBERS * box + 3 + axis];
    }

    /** Makes a box of another array so large that it holds a box of this one. */
    void extend(double[] other, int index, int box) {
        extend(other, index, values, box);
    }

    /** Makes a box of one array so large that it holds a box of another. */
    static void extend(double[] larger, int index, double[] boxes, int box) {
        int to = NUMBERS * index;
        int from = NUMBERS * box;
        larger[to] = Math.min(larger[to], boxes[from]);
        larger[to + 1] = Math.min(larger[to + 1], boxes[from + 1]);
        larger[to + 2] = Math.min(larger[to + 2], boxes[from + 2]);
        larger[to + 3] = Math.max(larger[to + 3], boxes[from + 3]);
        larger[to + 4] = Math.max(larger[to + 4], boxes[from + 4]);
        larger[to + 5] = Math.max(larger[to + 5], boxes[from + 5]);
    }

    /** The box around some boxes. */
    Bounds around(int from, int to) {
        double[] all = new double[NUMBERS];
        clear(all);
        for (int i = from; i < to; i++) {
            extend(all, 0, i);
        }
        return new Bounds(all[0], all[1], all[2], all[3], all[4], all[5]);
    }

    void swap(int first, int second) {
        for (int i = 0; i < NUMBERS; i++) {
            double value = values[NUMBERS * first + i];
            values[NUMBERS * first + i] = values[NUMBERS * second + i];
            values[NUMBERS * second + i] = value;
        }
    }

    /** Makes all boxes of an array empty. */
    static void clear(double[] boxes) {
        for (int i = 0; i < boxes.length; i += NUMBERS) {
            boxes[i] = Double.POSITIVE_INFINITY;
            boxes[i + 1] = Double.POSITIVE_INFINITY;
            boxes[i + 2] = Double.POSITIVE_INFINITY;
            boxes[i + 3] = Double.NEGATIVE_INFINITY;
            boxes[i + 4] = Double.NEGATIVE_INFINITY;
            boxes[i + 5] = Double.NEGATIVE_INFINITY;
        }
    }

    /** Half the area of the sides of a box. */
    static double halfArea(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x * y + y * z + z * x;
    }
}
