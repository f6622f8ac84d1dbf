package tompkins.search;

import java.util.Arrays;
import tompkins.primitive.Primitive;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** A few primitives, the nearest first, and which of them each ray of a packet may meet. One for each thread. */
final class Candidates extends Padded {

    /** Most primitives: this many bits of a double add up without rounding. */
    static final int MOST = 48;

    private final PacketFrustum bundle;
    private final Primitive[] found = new Primitive[MOST];
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

    /**
     * Adds those of some primitives, from one index (included) to another (excluded), that some ray of the frustum can
     * meet.
     *
     * @return false if there is no room for one of them
     */
    boolean addAll(Primitive[] primitives, int from, int to) {
        for (int i = from; i < to; i++) {
            if (bundle.misses(primitives[i])) {
                continue;
            }
            if (count == MOST) {
                return false;
            }
            insert(primitives[i], bundle.leastDistance(primitives[i]));
        }
        return true;
    }

    /** Nearer ones first: a ray that has met one need not try what lies behind. */
    private void insert(Primitive primitive, double leastDistance) {
        // what may lie anywhere, like a plane, comes first
        double least = leastDistance > 0 ? leastDistance : 0;
        int index = count++;
        while (index > 0 && leastDistances[index - 1] > least) {
            found[index] = found[index - 1];
            leastDistances[index] = leastDistances[index - 1];
            index--;
        }
        found[index] = primitive;
        leastDistances[index] = least;
    }

    /** Notes for each ray which candidates it may meet; short loops over all rays rule out most of the others. */
    void sift(RayPacket rays) {
        Arrays.fill(mayMeet, 0, rays.count(), (1L << count) - 1);
        for (int i = 0; i < count; i++) {
            if (found[i].overlaps(rays, bundle.hasOneStart(), bundle.farthest(), overlaps)) {
                takeOut(1L << i, rays.count());
            }
        }
    }

    /** Without a branch, so that the compiler makes instructions for several rays at once. */
    private void takeOut(double bit, int rayCount) {
        for (int ray = 0; ray < rayCount; ray++) {
            // -1 below 0, otherwise 0
            mayMeet[ray] += bit * Math.floor(overlaps[ray] * (1 / Primitive.LARGEST_OVERLAP));
        }
    }

    /** Whether the ray at an index may meet a candidate. */
    boolean mayMeet(int index) {
        return mayMeet[index] != 0;
    }

    /** The number of candidates that the ray at an index may meet. */
    int countFor(int index) {
        return Long.bitCount((long) mayMeet[index]);
    }

    /** Searches the candidates for a hit of the ray at an index that is nearer than what was found before. */
    void search(Ray ray, int index, NearestHit nearest) {
        int tests = 0;
        for (long left = (long) mayMeet[index]; left != 0; left &= left - 1) {
            int next = Long.numberOfTrailingZeros(left);
            if (leastDistances[next] > nearest.reach()) {
                break;
            }
            tests++;
            nearest.test(found[next], ray);
        }
        nearest.count(0, tests);
    }
}
