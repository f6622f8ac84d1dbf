package tompkins.search;

import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/**
 * The result of a search for the nearest primitive, with the memory that the search needs. One for each thread, used
 * again for every ray.
 */
public final class NearestHit extends Padded {

    /** Below this depth a tree is cut into halves of equal number, so that it ends at most 40 levels deeper. */
    static final int DEEPEST_CUT = 80;

    static final int DEEPEST_TREE = 128;

    final TreeNode[] waiting = new TreeNode[DEEPEST_TREE];
    final double[] entries = new double[DEEPEST_TREE];

    private final RayCounts counts;
    private Primitive primitive;
    private double distance;

    /** The memory of a thread; it counts the nodes and primitives that the thread's searches look at. */
    public NearestHit(RayCounts counts) {
        this.counts = counts;
    }

    /** Starts a search of everything nearer than {@code limit}. */
    void start(double limit) {
        primitive = null;
        distance = limit;
    }

    /** Goes on from what an earlier search has found. */
    public void resume(Primitive found, double foundDistance) {
        primitive = found;
        distance = foundDistance;
    }

    /**
     * Tests one primitive, which replaces what was found before if it is nearer: of equally near ones the one that is
     * listed first stays.
     */
    void test(Primitive candidate, Ray ray) {
        double candidateDistance = candidate.distance(ray, distance);
        if (candidateDistance < distance
                || (candidateDistance == distance
                        && candidateDistance < Primitive.NO_HIT
                        && (primitive == null || candidate.order() < primitive.order()))) {
            primitive = candidate;
            distance = candidateDistance;
        }
    }

    void count(long nodes, long tests) {
        counts.nodes += nodes;
        counts.tests += tests;
    }

    /** The nearest primitive, or null. */
    public Primitive primitive() {
        return primitive;
    }

    /** Distance of the nearest primitive. */
    public double distance() {
        return distance;
    }

    /** The hit on the nearest primitive, in memory that may be used again. */
    public Hit hit(Ray ray, Hit memory) {
        return primitive.hit(ray, distance, memory);
    }
}
