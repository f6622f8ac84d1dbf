package tompkins.search;

import java.util.Arrays;

/** Splits boxes by the best of the cuts between slices of equal width, across one axis. One for each thread. */
final class BinnedSplit {

    private static final int SLICES = 16;

    private final double costOfNode;

    private final int[] counts = new int[SLICES];
    private final double[] slices = new double[SLICES * Boxes.NUMBERS];
    private final double[] side = new double[Boxes.NUMBERS];
    private final double[] costs = new double[SLICES];

    private int axis;
    private double least;
    private double scale;

    private int bestAxis;
    private double bestLeast;
    private double bestScale;
    private int bestSlice;

    /** A split of boxes, where to visit a node costs as much as so many tests of a primitive. */
    BinnedSplit(double costOfNode) {
        this.costOfNode = costOfNode;
    }

    /**
     * Finds the cheapest cut.
     *
     * @param worth cost above which a cut is not worth while
     * @return whether there is one; none if all centres coincide
     */
    boolean choose(Boxes boxes, int from, int to, double worth) {
        double bestCost = worth;
        boolean found = false;
        for (axis = 0; axis < 3; axis++) {
            if (!slice(boxes, from, to)) {
                continue;
            }
            sweep(0, 1);
            // of the box around all
            double area = Boxes.halfArea(side);
            sweep(SLICES - 1, -1);
            for (int slice = 1; slice < SLICES; slice++) {
                double cost = costOfNode + costs[slice] / area;
                if (cost < bestCost) {
                    bestCost = cost;
                    bestAxis = axis;
                    bestLeast = least;
                    bestScale = scale;
                    bestSlice = slice;
                    found = true;
                }
            }
        }
        return found;
    }

    /** Whether a box lies below the chosen cut. */
    boolean isBelow(Boxes boxes, int box) {
        return sliceOf(boxes.twiceCentre(box, bestAxis), bestLeast, bestScale) < bestSlice;
    }

    private static int sliceOf(double twiceCentre, double least, double scale) {
        return Math.min(SLICES - 1, (int) ((twiceCentre - least) * scale));
    }

    /** Counts and bounds what lies in each slice; false if everything lies in one place. */
    private boolean slice(Boxes boxes, int from, int to) {
        least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = from; i < to; i++) {
            double centre = boxes.twiceCentre(i, axis);
            least = Math.min(least, centre);
            most = Math.max(most, centre);
        }
        scale = SLICES / (most - least);
        if (!(scale < Double.POSITIVE_INFINITY)) {
            return false;
        }
        Arrays.fill(counts, 0);
        Arrays.fill(costs, 0);
        Boxes.clear(slices);
        for (int i = from; i < to; i++) {
            int slice = sliceOf(boxes.twiceCentre(i, axis), least, scale);
            counts[slice]++;
            boxes.extend(slices, slice, i);
        }
        return true;
    }

    /** Adds to the cost of each cut the cost of the side from which the sweep comes; infinite if that is empty. */
    private void sweep(int first, int step) {
        Boxes.clear(side);
        int count = 0;
        double cost = Double.POSITIVE_INFINITY;
        for (int slice = first; slice >= 0 && slice < SLICES; slice += step) {
            if (counts[slice] > 0) {
                Boxes.extend(side, 0, slices, slice);
                count += counts[slice];
                cost = count * Boxes.halfArea(side);
            }
            int cut = step > 0 ? slice + 1 : slice;
            if (cut < SLICES) {
                costs[cut] += cost;
            }
        }
    }
}
