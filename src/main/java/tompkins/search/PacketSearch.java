package tompkins.search;

import java.util.ArrayDeque;
import java.util.Iterator;
import tompkins.primitive.Primitive;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/**
 * The search for what the rays of a packet meet among the objects of one frame, with the same result as that of a
 * search for each. Where that pays, it is made for all rays together, which is several times faster. If they can meet
 * only a few primitives, these are found once for all rays. If there are more, they are taken in batches, the nearest
 * first, until all rays but a few have met something nearer than what waits. If there are too many, the tree is
 * searched for each ray. One for each thread, used again for every packet.
 */
public final class PacketSearch extends Padded {

    /** If the rays meet more parts of the tree than this at once, they also meet too many primitives in them. */
    private static final int MOST_WAITING = 64;

    /** Number of candidates by which it is decided whether batches are worth while. */
    private static final int PROBES = 8;

    /** Batches are worth while if so many rays may meet a candidate on average; specks are left to each ray. */
    private static final int LEAST_RAYS = 4;

    /** When only this many rays are open, each searches the rest by itself. */
    private static final int FEW_RAYS = 24;

    /** If the way to the next batch takes more steps, batches are not worth while either. */
    private static final int MOST_STEPS = 400;

    private final ObjectTree objects;
    private final NearestHit nearest;
    private RayPacket rays;

    /** Whether what each ray can meet was found for all together. */
    boolean together;

    private final PacketFrustum bundle = new PacketFrustum();
    private final Candidates candidates = new Candidates(bundle);

    /** The parts of the tree that wait to be opened; one that is opened leaves two in its place at most. */
    private final ArrayDeque<TreeNode> waiting = new ArrayDeque<>(NearestHit.DEEPEST_TREE);

    // what each ray has met so far, if there is more than one batch
    private boolean inBatches;
    private final Primitive[] hits = new Primitive[RayPacket.MOST];
    private final double[] distances = new double[RayPacket.MOST];
    private final double[] reaches = new double[RayPacket.MOST];
    private final boolean[] shared = new boolean[RayPacket.MOST];

    /** Places of the rays that may still meet something nearer. */
    private final int[] open = new int[RayPacket.MOST];

    private int openCount;

    private final Ray ray = Ray.blank();

    /** A search among objects, whose results the memory holds. */
    public PacketSearch(ObjectTree objects, NearestHit nearest) {
        this.objects = objects;
        this.nearest = nearest;
    }

    /** Begins to search for the rays of a packet, which must stay as they are. */
    public void begin(RayPacket newRays) {
        rays = newRays;
        together = findAll();
    }

    /** Whether what each ray can meet was found; else the rays spread too widely, or meet too many primitives. */
    private boolean findAll() {
        inBatches = false;
        candidates.clear();
        waiting.clear();
        if (rays.count() == 0
                || !bundle.enclose(rays)
                || !candidates.addAll(objects.listed(), 0, objects.listed().length)) {
            return false;
        }
        if (objects.root() != null && !bundle.misses(objects.root())) {
            waiting.add(objects.root());
        }
        boolean batches = !objects.isMostlyLong() && gather(PROBES) && (waiting.isEmpty() || batchesPay());
        if (!(batches ? gather(Candidates.MOST) : gatherAll())) {
            return false;
        }
        candidates.sift(rays);
        inBatches = !waiting.isEmpty();
        if (inBatches) {
            searchInBatches();
        }
        return true;
    }

    /** Whether the candidates are so large that each is in the way of several rays; then batches are worth while. */
    private boolean batchesPay() {
        candidates.sift(rays);
        int pairs = 0;
        for (int index = 0; index < rays.count(); index++) {
            pairs += candidates.countFor(index);
        }
        return pairs >= LEAST_RAYS * candidates.count();
    }

    /** Gathers everything that the rays can meet, level by level, so that it notices soon if that is too much. */
    private boolean gatherAll() {
        while (!waiting.isEmpty() && waiting.size() <= MOST_WAITING) {
            TreeNode node = waiting.poll();
            if (node.primitives == null) {
                putOff(node.low);
                putOff(node.high);
            } else if (!candidates.addAll(node.primitives, node.from, node.to)) {
                return false;
            }
        }
        return waiting.isEmpty();
    }

    /** Lets a node wait unless all rays miss it. */
    private void putOff(TreeNode node) {
        if (!bundle.misses(node)) {
            waiting.add(node);
        }
    }

    /**
     * Gathers what lies nearest.
     *
     * @param enough number of candidates
     * @return false if the way is too long
     */
    private boolean gather(int enough) {
        for (int steps = 0; steps < MOST_STEPS; steps++) {
            TreeNode node = waiting.peekLast();
            if (node == null || candidates.count() >= enough) {
                return true;
            }
            if (node.primitives != null && !candidates.hasRoomFor(node.size())) {
                return true;
            }
            waiting.removeLast();
            if (node.primitives == null) {
                open(node);
            } else {
                candidates.addAll(node.primitives, node.from, node.to);
            }
        }
        return false;
    }

    private void open(TreeNode node) {
        boolean lowFirst = bundle.leastDistance(node.low) <= bundle.leastDistance(node.high);
        putOff(lowFirst ? node.high : node.low);
        putOff(lowFirst ? node.low : node.high);
    }

    private void openAll() {
        for (int index = 0; index < rays.count(); index++) {
            hits[index] = null;
            distances[index] = Primitive.NO_HIT;
            reaches[index] = Primitive.NO_HIT;
            shared[index] = false;
            open[index] = index;
        }
        openCount = rays.count();
    }

    private void searchInBatches() {
        openAll();
        boolean more = true;
        while (more) {
            searchBatch();
            closeRays();
            if (openCount <= FEW_RAYS) {
                break;
            }
            candidates.clear();
            more = gather(Candidates.MOST);
            candidates.sift(rays);
        }
        if (!more) {
            searchBatch();
        }
        searchWaiting();
    }

    private void searchBatch() {
        for (int i = 0; i < openCount; i++) {
            int index = open[i];
            if (candidates.mayMeet(index)) {
                nearest.resume(hits[index], distances[index], reaches[index], shared[index]);
                candidates.search(rays.copy(index, ray), index, nearest);
                keep(index);
            }
        }
    }

    /** Closes the rays that have met something nearer than everything that waits. */
    private void closeRays() {
        double front = Primitive.NO_HIT;
        for (TreeNode node : waiting) {
            front = Math.min(front, bundle.leastDistance(node));
        }
        int left = 0;
        for (int i = 0; i < openCount; i++) {
            if (!waiting.isEmpty() && reaches[open[i]] >= front) {
                open[left++] = open[i];
            }
        }
        openCount = left;
    }

    /** Lets each ray that is still open search by itself what waits. */
    private void searchWaiting() {
        for (int i = 0; i < openCount; i++) {
            int index = open[i];
            rays.copy(index, ray);
            nearest.resume(hits[index], distances[index], reaches[index], shared[index]);
            for (Iterator<TreeNode> nearestFirst = waiting.descendingIterator(); nearestFirst.hasNext(); ) {
                ObjectTree.searchTree(nearestFirst.next(), ray, nearest);
            }
            keep(index);
        }
    }

    private void keep(int index) {
        hits[index] = nearest.primitive();
        distances[index] = nearest.distance();
        reaches[index] = nearest.reach();
        shared[index] = nearest.isShared();
    }

    /** Whether some ray may meet something. */
    public boolean mayMeet() {
        return !together || inBatches || candidates.count() > 0;
    }

    /** Whether the ray at an index may meet something. */
    public boolean mayMeet(int index) {
        return !together || (inBatches ? hits[index] != null : candidates.mayMeet(index));
    }

    /**
     * Searches for the nearest hit of a ray; asked in the order of the packet.
     *
     * @param limit what is farther may be left out
     * @return whether there is one; the memory holds it, and {@link #ray()} the ray
     */
    public boolean nearest(int index, double limit) {
        if (!together) {
            return objects.nearest(rays.copy(index, ray), limit, nearest);
        }
        if (!mayMeet(index)) {
            return false;
        }
        rays.copy(index, ray);
        if (inBatches) {
            nearest.resume(hits[index], distances[index], reaches[index], shared[index]);
        } else {
            nearest.start(limit);
            candidates.search(ray, index, nearest);
        }
        return nearest.primitive() != null;
    }

    /** The ray whose hit was found last. */
    public Ray ray() {
        return ray;
    }
}
