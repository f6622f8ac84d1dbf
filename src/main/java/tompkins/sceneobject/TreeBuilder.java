package tompkins.sceneobject;

import java.util.List;

/**
 * Builds a bounding-volume tree by the surface-area heuristic: a cut is good if few primitives lie in boxes that many rays
 * meet. Cuts are chosen among sixteen along each axis.
 */
final class TreeBuilder {

    private static final int SLICES = 16;

    private static final int SMALLEST_INNER_NODE = 3;

    /** Cost of visiting a node, in tests of a primitive. */
    private static final double COST_OF_NODE = 0.7;

    private final Primitive[] primitives;
    private final Bounds[] bounds;

    private TreeBuilder(List<Primitive> all) {
        primitives = all.toArray(Primitive[]::new);
        bounds = new Bounds[primitives.length];
        for (int i = 0; i < primitives.length; i++) {
            bounds[i] = primitives[i].bounds();
        }
    }

    /** The tree of primitives that all have bounds; at least one. */
    static TreeNode build(List<Primitive> primitives) {
        TreeBuilder builder = new TreeBuilder(primitives);
        return builder.node(0, primitives.size(), 0);
    }

    private TreeNode node(int from, int to, int depth) {
        Bounds all = bounds[from];
        for (int i = from + 1; i < to; i++) {
            all = all.with(bounds[i]);
        }
        if (to - from < SMALLEST_INNER_NODE) {
            return leaf(all, from, to);
        }
        Cut cut = bestCut(from, to, all);
        if (cut == null && to - from <= 2 * SMALLEST_INNER_NODE) {
            return leaf(all, from, to);
        }
        int middle = cut == null || depth > NearestHit.DEEPEST_CUT ? (from + to) / 2 : split(from, to, cut);
        return new TreeNode(all, node(from, middle, depth + 1), node(middle, to, depth + 1));
    }

    private TreeNode leaf(Bounds all, int from, int to) {
        Primitive[] held = new Primitive[to - from];
        System.arraycopy(primitives, from, held, 0, held.length);
        return new TreeNode(all, held);
    }

    private record Cut(int axis, double least, double scale, int slice) {

        int sliceOf(Bounds box) {
            return Math.min(SLICES - 1, (int) ((box.twiceCentre(axis) - least) * scale));
        }
    }

    /** The cheapest cut, or null if leaving the primitives together is cheaper or all centres coincide. */
    private Cut bestCut(int from, int to, Bounds all) {
        Cut best = null;
        double bestCost = to - from <= 2 * SMALLEST_INNER_NODE ? to - from : Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                double centre = bounds[i].twiceCentre(axis);
                least = Math.min(least, centre);
                most = Math.max(most, centre);
            }
            double scale = SLICES / (most - least);
            if (!(scale < Double.POSITIVE_INFINITY)) {
                continue;
            }
            double[] costs = costs(from, to, new Cut(axis, least, scale, 0), all.halfArea());
            for (int slice = 1; slice < SLICES; slice++) {
                if (costs[slice] < bestCost) {
                    bestCost = costs[slice];
                    best = new Cut(axis, least, scale, slice);
                }
            }
        }
        return best;
    }

    /** The expected cost of a cut below each slice; infinite where one side would be empty. */
    private double[] costs(int from, int to, Cut slices, double area) {
        int[] counts = new int[SLICES];
        Bounds[] boxes = new Bounds[SLICES];
        for (int i = from; i < to; i++) {
            int slice = slices.sliceOf(bounds[i]);
            counts[slice]++;
            boxes[slice] = boxes[slice] == null ? bounds[i] : boxes[slice].with(bounds[i]);
        }
        double[] costs = new double[SLICES];
        sweep(counts, boxes, costs, 0, 1);
        sweep(counts, boxes, costs, SLICES - 1, -1);
        for (int slice = 1; slice < SLICES; slice++) {
            costs[slice] = COST_OF_NODE + costs[slice] / area;
        }
        return costs;
    }

    private static void sweep(int[] counts, Bounds[] boxes, double[] costs, int first, int step) {
        Bounds box = null;
        int count = 0;
        for (int slice = first; slice >= 0 && slice < SLICES; slice += step) {
            if (boxes[slice] != null) {
                box = box == null ? boxes[slice] : box.with(boxes[slice]);
                count += counts[slice];
            }
            int cut = step > 0 ? slice + 1 : slice;
            if (cut < SLICES) {
                costs[cut] += box == null ? Double.POSITIVE_INFINITY : count * box.halfArea();
            }
        }
    }

    /** Moves what lies below the cut to the front. */
    private int split(int from, int to, Cut cut) {
        int middle = from;
        for (int i = from; i < to; i++) {
            if (cut.sliceOf(bounds[i]) < cut.slice()) {
                Primitive primitive = primitives[i];
                primitives[i] = primitives[middle];
                primitives[middle] = primitive;
                Bounds box = bounds[i];
                bounds[i] = bounds[middle];
                bounds[middle] = box;
                middle++;
            }
        }
        return middle;
    }
}
