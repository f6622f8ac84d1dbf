package tompkins.search;

import java.util.List;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/**
 * Where a few neighbouring rays enter the tree: the way from its root down to the parts that they can meet is walked
 * only once for all of them. Each ray gets the same result as in a search of its own. One for each thread, used again
 * for every few rays.
 */
final class EntryNodes extends Padded {

    /** The number of rays that is fastest; any other gives the same results. */
    static final int RAYS = 32;

    /** With more parts it is quicker to begin at the root. */
    static final int MOST_PARTS = 128;

    /** With this number of nodes no further one is opened: more would cost each ray more than they save. */
    private static final int MOST = 16;

    /** Most steps down the tree. */
    private static final int MOST_STEPS = 32;

    private final PacketFrustum bundle = new PacketFrustum();
    private final TreeNode[] nodes = new TreeNode[MOST_PARTS];
    private final double[] distances = new double[MOST_PARTS];
    private int count;

    /** What is still to be looked at, the nearest last. */
    private final TreeNode[] waiting = new TreeNode[MOST_PARTS];

    private final double[] waitingDistances = new double[MOST_PARTS];
    private int waitingCount;

    /**
     * Looks for the nodes through which some rays enter the tree.
     *
     * @param parts parts of the tree that together hold everything that the rays can meet; empty for all of it
     * @param rays a packet that holds the rays
     * @param from index of the first ray
     * @param to index behind the last ray
     * @return false if there is no tree, or if the rays spread too widely
     */
    boolean find(ObjectTree objects, List<TreeNode> parts, RayPacket rays, int from, int to) {
        count = 0;
        waitingCount = 0;
        if (objects.root() == null || !bundle.enclose(rays, from, to)) {
            return false;
        }
        if (parts.isEmpty()) {
            add(objects.root());
        }
        for (int i = 0; i < parts.size(); i++) {
            add(parts.get(i));
        }
        int steps = 0;
        // the nearest are opened first, since most rays end there
        while (waitingCount > 0 && count + waitingCount < MOST && steps < MOST_STEPS) {
            TreeNode nearest = waiting[waitingCount - 1];
            if (nearest.primitives == null) {
                waitingCount--;
                add(nearest.low);
                add(nearest.high);
                steps++;
            } else {
                keepNearest();
            }
        }
        while (waitingCount > 0) {
            keepNearest();
        }
        return true;
    }

    private void keepNearest() {
        waitingCount--;
        nodes[count] = waiting[waitingCount];
        distances[count++] = waitingDistances[waitingCount];
    }

    /** Adds a node unless all rays miss it, before those that are nearer. */
    private void add(TreeNode node) {
        if (bundle.misses(node)) {
            return;
        }
        double distance = bundle.leastDistance(node);
        int index = waitingCount++;
        while (index > 0 && waitingDistances[index - 1] < distance) {
            waiting[index] = waiting[index - 1];
            waitingDistances[index] = waitingDistances[index - 1];
            index--;
        }
        waiting[index] = node;
        waitingDistances[index] = distance;
    }

    /** Number of nodes, the nearest first. */
    int count() {
        return count;
    }

    TreeNode node(int index) {
        return nodes[index];
    }

    /** A distance that no ray falls below before it reaches a node. */
    double distance(int index) {
        return distances[index];
    }
}
