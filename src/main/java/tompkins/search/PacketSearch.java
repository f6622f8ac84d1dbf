package tompkins.search;

import java.util.ArrayDeque;
import java.util.Iterator;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/**
 * Searches for all rays of a packet at once, several times faster than for each, with the same result. If the rays can
 * meet only a few primitives, these are found once for all rays. If there are more, they are taken in batches, the
 * nearest first, until all rays but a few have met something nearer than what waits. One for each thread, used again
 * for every packet.
 */
final class PacketSearch {

    /** If the rays meet more parts of the tree than this at once, they also meet too many primitives in them. */
    private static final int MOST_WAITING = 64;

    /**
     * With this many parts that hold {@link #MANY} primitives each on average, there are too many: the rest need not be
     * opened.
     */
    private static final int MOST_LARGE_WAITING = 12;

    private static final int MANY = 1000;

    /** Number of candidates by which it is decided whether batches are worth while. */
    private static final int PROBES = 8;

    /**
     * Batches are worth while if this many rays may meet a candidate on average; objects as small as a pixel are left
     * to each ray.
     */
    private static final int LEAST_RAYS = 4;

    /** When only this many rays are open, each searches the rest by itself. */
    private static final int FEW_RAYS = 24;

    /** If the way to the next batch takes more steps, batches are not worth while either. */
    private static final int MOST_STEPS = 400;

    private final PacketFrustum bundle = new PacketFrustum();
    private final Candidates candidates = new Candidates(bundle);

    /** The parts of the tree that wait to be opened; one that is opened leaves two in its place at most. */
    private final ArrayDeque<TreeNode> waiting = new ArrayDeque<>(NearestHit.DEEPEST_TREE);

    /** The leaves in which candidates were found. */
    private final ArrayDeque<TreeNode> candidateLeaves = new ArrayDeque<>(Candidates.MOST + 1);

    // what each ray has met so far, if there is more than one batch
    private boolean inBatches;
    private final Primitive[] hits = new Primitive[RayPacket.MOST];
    private final double[] distances = new double[RayPacket.MOST];

    /** Places of the rays that may still meet something nearer. */
    private final int[] open = new int[RayPacket.MOST];

    private int openCount;
    private final Ray rayMemory = Ray.blank();
    private final TreeParts parts = new TreeParts();

    /**
     * Searches for the rays of a packet.
     *
     * @param objects all primitives of the frame
     * @param rays the rays; at most {@link RayPacket#MOST}
     * @param scratch memory for the search, and its counts
     * @return null if what each ray meets was found: ask {@link #nearest} for it. Otherwise the rays spread too widely,
     *     or can meet too many primitives; search the tree for each, from these parts on if there are any.
     */
    TreeParts find(ObjectTree objects, RayPacket rays, NearestHit scratch) {
        return findAll(objects, rays, scratch) ? null : partsFound();
    }

    private boolean findAll(ObjectTree objects, RayPacket rays, NearestHit scratch) {
        inBatches = false;
        clearCandidates();
        waiting.clear();
        if (rays.count() == 0
                || !bundle.enclose(rays, 0, rays.count())
                || !candidates.addAll(objects.listed(), 0, objects.listed().length)) {
            return false;
        }
        if (objects.root() != null && !bundle.misses(objects.root())) {
            waiting.add(objects.root());
        }
        boolean batches = !objects.isMostlyLong() && gather(PROBES) && (waiting.isEmpty() || batchesPay(rays));
        if (!(batches ? gather(Candidates.MOST) : gatherAll())) {
            return false;
        }
        candidates.sift(rays);
        inBatches = !waiting.isEmpty();
        if (inBatches) {
            searchInBatches(rays, scratch);
        }
        return true;
    }

    /** Whether the candidates are so large that each is in the way of several rays; then batches are worth while. */
    private boolean batchesPay(RayPacket rays) {
        candidates.sift(rays);
        int pairs = 0;
        for (int place = 0; place < rays.count(); place++) {
            pairs += candidates.countFor(place);
        }
        return pairs >= LEAST_RAYS * candidates.count();
    }

    /**
     * Gathers everything that the rays can meet. It goes level by level, so that it notices many parts before it has
     * searched one of them to its end. Long primitives are in the way of many rays at many distances and are not taken
     * in batches.
     */
    private boolean gatherAll() {
        int held = 0;
        for (TreeNode node : waiting) {
            held += node.size();
        }
        while (!waiting.isEmpty() && !areTooMany(waiting.size(), held)) {
            TreeNode node = waiting.poll();
            held -= node.size();
            if (node.primitives == null) {
                held += putOff(node.low) ? node.low.size() : 0;
                held += putOff(node.high) ? node.high.size() : 0;
            } else if (!addCandidates(node)) {
                return false;
            }
        }
        return waiting.isEmpty();
    }

    private void clearCandidates() {
        candidates.clear();
        candidateLeaves.clear();
    }

    private boolean addCandidates(TreeNode leaf) {
        int before = candidates.count();
        boolean added = candidates.addAll(leaf.primitives, leaf.from, leaf.to);
        if (!added || candidates.count() > before) {
            candidateLeaves.add(leaf);
        }
        return added;
    }

    private static boolean areTooMany(int parts, int held) {
        return parts > MOST_WAITING || (parts > MOST_LARGE_WAITING && held > MANY * parts);
    }

    /** Lets a node wait unless all rays miss it, and says whether it waits. */
    private boolean putOff(TreeNode node) {
        return !bundle.misses(node) && waiting.add(node);
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
                addCandidates(node);
            }
        }
        return false;
    }

    private void open(TreeNode node) {
        boolean lowFirst = bundle.leastDistance(node.low) <= bundle.leastDistance(node.high);
        putOff(lowFirst ? node.high : node.low);
        putOff(lowFirst ? node.low : node.high);
    }

    private TreeParts partsFound() {
        parts.clear();
        if (candidateLeaves.size() + waiting.size() <= TreeParts.MOST) {
            candidateLeaves.forEach(parts::add);
            waiting.forEach(parts::add);
        }
        return parts;
    }

    private void openAll(int rayCount) {
        for (int place = 0; place < rayCount; place++) {
            hits[place] = null;
            distances[place] = Primitive.NO_HIT;
            open[place] = place;
        }
        openCount = rayCount;
    }

    private void searchInBatches(RayPacket rays, NearestHit scratch) {
        openAll(rays.count());
        boolean more = true;
        while (more) {
            searchBatch(rays, scratch);
            closeRays();
            if (openCount <= FEW_RAYS) {
                break;
            }
            clearCandidates();
            more = gather(Candidates.MOST);
            candidates.sift(rays);
        }
        if (!more) {
            searchBatch(rays, scratch);
        }
        searchWaiting(rays, scratch);
    }

    private void searchBatch(RayPacket rays, NearestHit scratch) {
        for (int i = 0; i < openCount; i++) {
            int place = open[i];
            if (candidates.mayMeet(place)) {
                scratch.resume(hits[place], distances[place]);
                candidates.search(rays.copy(place, rayMemory), place, scratch);
                keep(place, scratch);
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
            if (!waiting.isEmpty() && distances[open[i]] >= front) {
                open[left++] = open[i];
            }
        }
        openCount = left;
    }

    /** Lets each ray that is still open search by itself what waits. */
    private void searchWaiting(RayPacket rays, NearestHit scratch) {
        for (int i = 0; i < openCount; i++) {
            int place = open[i];
            Ray ray = rays.copy(place, rayMemory);
            scratch.resume(hits[place], distances[place]);
            for (Iterator<TreeNode> nearestFirst = waiting.descendingIterator(); nearestFirst.hasNext(); ) {
                ObjectTree.searchTree(nearestFirst.next(), ray, scratch);
            }
            keep(place, scratch);
        }
    }

    private void keep(int place, NearestHit nearest) {
        hits[place] = nearest.primitive();
        distances[place] = nearest.distance();
    }

    /** Whether a ray may meet something. */
    boolean mayMeet() {
        return inBatches || candidates.count() > 0;
    }

    /** Whether the ray at a place may meet something. */
    boolean mayMeet(int place) {
        return inBatches ? hits[place] != null : candidates.mayMeet(place);
    }

    /**
     * The nearest that a ray hits.
     *
     * @param ray one of the rays of the packet
     * @param place its place
     * @param limit what is farther may be left out
     * @param nearest gets the result
     * @return whether there is one
     */
    boolean nearest(Ray ray, int place, double limit, NearestHit nearest) {
        if (inBatches) {
            nearest.resume(hits[place], distances[place]);
        } else {
            nearest.start(limit);
            candidates.search(ray, place, nearest);
        }
        return nearest.primitive() != null;
    }
}
