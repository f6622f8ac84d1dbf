package tompkins.sceneobject;

import java.util.ArrayDeque;
import java.util.Arrays;
import tompkins.ray.Ray;
import tompkins.ray.RayBlock;

/**
 * The few primitives that a block of neighbouring rays can meet, found once for all of them. Searching them gives the
 * same result as searching everything, several times faster. One for each thread, used again for every block.
 */
public final class Candidates {

    /** With more candidates than this the tree is faster. */
    private static final int MOST = 48;

    /** Where the rays meet more parts of the tree than this at once, they meet too many primitives in them, too. */
    private static final int MOST_WAITING = 64;

    private final RayBundle bundle = new RayBundle();

    /** The parts of the tree that wait to be opened; one that is opened leaves two in its place at most. */
    private final ArrayDeque<TreeNode> waiting = new ArrayDeque<>(MOST_WAITING + 2);

    private final Primitive[] found = new Primitive[MOST];
    private final double[] leastDistances = new double[MOST];
    private int count;

    private final double[] margins = new double[RayBlock.MOST];

    /** For each ray a bit for each candidate that it may meet. */
    private final long[] mayMeet = new long[RayBlock.MOST];

    /**
     * Looks for the primitives that some rays can meet.
     *
     * @param objects all primitives of the frame
     * @param rays the rays; at most {@link RayBlock#MOST}
     * @return false if the rays spread too widely, or can meet too many primitives; search the tree instead
     */
    public boolean find(ObjectTree objects, RayBlock rays) {
        count = 0;
        if (rays.count() == 0 || !bundle.enclose(rays, 0, rays.count())) {
            return false;
        }
        for (Primitive primitive : objects.listed()) {
            if (!add(primitive)) {
                return false;
            }
        }
        if (objects.root() != null && !searchTree(objects.root())) {
            return false;
        }
        sift(rays);
        return true;
    }

    /** Notes for each ray which candidates it may meet; a few short loops over all rays rule out most of the others. */
    private void sift(RayBlock rays) {
        Arrays.fill(mayMeet, 0, rays.count(), 0);
        for (int i = 0; i < count; i++) {
            if (!found[i].margins(rays, bundle.farthest(), margins)) {
                Arrays.fill(margins, 0, rays.count(), 0);
            }
            note(1L << i, rays.count());
        }
    }

    private void note(long bit, int rayCount) {
        for (int ray = 0; ray < rayCount; ray++) {
            mayMeet[ray] |= margins[ray] < 0 ? 0 : bit;
        }
    }

    /** Level by level, so that many parts are told from few before one of them is searched to its end. */
    private boolean searchTree(TreeNode root) {
        waiting.clear();
        putOff(root);
        while (!waiting.isEmpty() && waiting.size() <= MOST_WAITING) {
            TreeNode node = waiting.poll();
            if (node.primitives == null) {
                putOff(node.low);
                putOff(node.high);
                continue;
            }
            for (Primitive primitive : node.primitives) {
                if (!add(primitive)) {
                    return false;
                }
            }
        }
        return waiting.isEmpty();
    }

    private void putOff(TreeNode node) {
        if (!bundle.misses(node)) {
            waiting.add(node);
        }
    }

    private boolean add(Primitive primitive) {
        if (bundle.misses(primitive)) {
            return true;
        }
        if (count == MOST) {
            return false;
        }
        insert(primitive, bundle.leastDistance(primitive));
        return true;
    }

    /** Nearer ones first: whoever has met one need not try what lies behind. */
    private void insert(Primitive primitive, double leastDistance) {
        // what may lie anywhere, like a plane, comes first
        double least = leastDistance > 0 ? leastDistance : 0;
        int place = count++;
        while (place > 0 && leastDistances[place - 1] > least) {
            found[place] = found[place - 1];
            leastDistances[place] = leastDistances[place - 1];
            place--;
        }
        found[place] = primitive;
        leastDistances[place] = least;
    }

    /** Whether the ray at a place may meet a candidate; it meets nothing else. */
    public boolean mayMeet(int place) {
        return mayMeet[place] != 0;
    }

    /**
     * Searches the nearest candidate that a ray hits.
     *
     * @param ray one of the rays for which the candidates were found
     * @param place its place among them
     * @param nearest gets the result
     * @return whether there is one
     */
    public boolean nearest(Ray ray, int place, NearestHit nearest) {
        Primitive primitive = null;
        double distance = Primitive.NO_HIT;
        int tests = 0;
        for (long left = mayMeet[place]; left != 0; left &= left - 1) {
            int next = Long.numberOfTrailingZeros(left);
            if (leastDistances[next] > distance) {
                break;
            }
            tests++;
            Primitive candidate = found[next];
            double candidateDistance = candidate.distance(ray, distance);
            if (NearestHit.isNearer(candidate, candidateDistance, primitive, distance)) {
                primitive = candidate;
                distance = candidateDistance;
            }
        }
        nearest.end(primitive, distance);
        nearest.count(0, tests);
        return primitive != null;
    }
}
