package tompkins.search;

import java.util.Arrays;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/**
 * A few primitives that the rays of a packet may meet, the nearest first, with a note for each ray which of them it may
 * meet. One for each thread, filled again and again.
 */
final class Candidates {

    /** Most primitives: this many bits of a double add up without rounding. */
    static final int MOST = 48;

    private final PacketFrustum bundle;
    private final Primitive[] found = new Primitive[MOST];
    private final TreeNode[] leaves = new TreeNode[MOST];
    private final double[] leastDistances = new double[MOST];
    private int count;

    private final double[] overlaps = new double[RayPacket.MOST];

    /** For each ray the sum of a power of two for each candidate that it may meet. */
    private final double[] mayMeet = new double[RayPacket.MOST];

    /** Candidates for the rays of a frustum. */
    Candidates(PacketFrustum bundle) {
        this.bundle = bundle;
    }

    /** Forgets all. */
    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /** Whether there is room for so many more. */
    boolean hasRoomFor(int more) {
        return count + more <= MOST;
    }

    /** As {@link #add(Primitive, TreeNode)}, for several that no leaf holds. */
    boolean addAll(Primitive[] primitives) {
        for (Primitive primitive : primitives) {
            if (!add(primitive, null)) {
                return false;
            }
        }
        return true;
    }

    /** As {@link #add(Primitive, TreeNode)}, for all that a leaf holds. */
    boolean addAll(TreeNode leaf) {
        for (int i = leaf.from; i < leaf.to; i++) {
            if (!add(leaf.primitives[i], leaf)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Adds a primitive if some ray of the frustum can meet it.
     *
     * @param leaf the leaf that holds it, or null if none does
     * @return false if there is no room for it
     */
    private boolean add(Primitive primitive, TreeNode leaf) {
        if (bundle.misses(primitive)) {
            return true;
        }
        if (count == MOST) {
            return false;
        }
        insert(primitive, leaf, bundle.leastDistance(primitive));
        return true;
    }

    /** Nearer ones first: a ray that has met one need not try what lies behind. */
    private void insert(Primitive primitive, TreeNode leaf, double leastDistance) {
        // what may lie anywhere, like a plane, comes first
        double least = leastDistance > 0 ? leastDistance : 0;
        int place = count++;
        while (place > 0 && leastDistances[place - 1] > least) {
            found[place] = found[place - 1];
            leaves[place] = leaves[place - 1];
            leastDistances[place] = leastDistances[place - 1];
            place--;
        }
        found[place] = primitive;
        leaves[place] = leaf;
        leastDistances[place] = least;
    }

    /** Notes for each ray which candidates it may meet; short loops over all rays rule out most of the others. */
    void sift(RayPacket rays) {
        Arrays.fill(mayMeet, 0, rays.count(), (1L << count) - 1);
        for (int i = 0; i < count; i++) {
            if (found[i].overlaps(rays, bundle.starts(), overlaps)) {
                takeOut(1L << i, rays.count());
            }
        }
    }

    /** Uses no branch and one kind of number, so that the compiler makes instructions for several rays at once. */
    private void takeOut(double bit, int rayCount) {
        for (int ray = 0; ray < rayCount; ray++) {
            // -1 below 0, otherwise 0
            mayMeet[ray] += bit * Math.floor(overlaps[ray] * (1 / Primitive.LARGEST_OVERLAP));
        }
    }

    /** Whether the ray at a place may meet a candidate. */
    boolean mayMeet(int place) {
        return mayMeet[place] != 0;
    }

    /** The number of candidates that the ray at a place may meet. */
    int countFor(int place) {
        return Long.bitCount((long) mayMeet[place]);
    }

    /** Searches the candidates for a hit of the ray at a place that is nearer than what was found before. */
    void search(Ray ray, int place, NearestHit nearest) {
        int tests = 0;
        for (long left = (long) mayMeet[place]; left != 0; left &= left - 1) {
            int next = Long.numberOfTrailingZeros(left);
            if (leastDistances[next] > nearest.distance()) {
                break;
            }
            tests++;
            if (nearest.test(found[next], ray)) {
                nearest.foundIn(leaves[next]);
            }
        }
        nearest.count(0, tests);
    }
}
