package tompkins.search;

import java.util.concurrent.ForkJoinTask;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/**
 * Builds a bounding-volume tree by the surface-area heuristic: a cut is good if few primitives lie in boxes that many
 * rays meet. Cuts are chosen among sixteen along each axis ({@link BinnedSplit}). Halves of large trees are built in
 * parallel; the tree is the same whatever the number of threads.
 */
final class TreeBuilder {

    private static final int SMALLEST_INNER_NODE = 3;
    private static final int LARGEST_LEAF = 16;

    /** With fewer primitives a second thread costs more than it gains. */
    private static final int SMALLEST_PARALLEL_NODE = 4096;

    private final Primitive[] primitives;
    private final double costOfNode;
    private final Boxes boxes;

    private TreeBuilder(Primitive[] primitives, double costOfNode) {
        this.primitives = primitives;
        this.costOfNode = costOfNode;
        boxes = new Boxes(primitives);
    }

    /**
     * Builds a tree.
     *
     * @param primitives what it holds, all with bounds; at least one. Afterwards the array holds copies of them in the
     *     order of the leaves, which also lie in memory in this order: what is searched together lies together
     * @param costOfNode cost of visiting a node, in tests of a primitive: leaves hold more if it is high
     */
    static TreeNode build(Primitive[] primitives, double costOfNode) {
        return new TreeBuilder(primitives, costOfNode)
                .task(0, primitives.length, 0)
                .invoke();
    }

    private ForkJoinTask<TreeNode> task(int from, int to, int depth) {
        return ForkJoinTask.adapt(() -> node(from, to, depth, new BinnedSplit(costOfNode)));
    }

    private TreeNode node(int from, int to, int depth, BinnedSplit cuts) {
        Bounds all = boxes.around(from, to);
        int middle = to - from < SMALLEST_INNER_NODE ? -1 : middle(from, to, depth, cuts);
        if (middle < 0) {
            return leaf(all, from, to);
        }
        if (to - from < SMALLEST_PARALLEL_NODE) {
            return new TreeNode(all, node(from, middle, depth + 1, cuts), node(middle, to, depth + 1, cuts));
        }
        ForkJoinTask<TreeNode> high = task(middle, to, depth + 1).fork();
        return new TreeNode(all, node(from, middle, depth + 1, cuts), high.join());
    }

    private TreeNode leaf(Bounds all, int from, int to) {
        for (int i = from; i < to; i++) {
            primitives[i] = primitives[i].copy();
        }
        return new TreeNode(all, primitives, from, to);
    }

    /** Parts the primitives and says where the second part begins; -1 if they are better left together. */
    private int middle(int from, int to, int depth, BinnedSplit cuts) {
        boolean small = to - from <= LARGEST_LEAF;
        boolean cut = cuts.choose(boxes, from, to, small ? to - from : Double.POSITIVE_INFINITY);
        if (!cut && small) {
            return -1;
        }
        return !cut || depth > NearestHit.DEEPEST_CUT ? (from + to) / 2 : split(from, to, cuts);
    }

    /** Moves what lies below the cut to the front. */
    private int split(int from, int to, BinnedSplit cuts) {
        int middle = from;
        for (int i = from; i < to; i++) {
            if (cuts.isBelow(boxes, i)) {
                Primitive primitive = primitives[i];
                primitives[i] = primitives[middle];
                primitives[middle] = primitive;
                boxes.swap(i, middle);
                middle++;
            }
        }
        return middle;
    }
}
