package tompkins.search;

import tompkins.primitive.Primitive;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/**
 * The result of a search for the nearest primitive, with the memory that the search needs. One for each thread, used
 * again for every ray.
 */
public final class NearestHit {

    /** Below this depth a tree is cut into halves of equal number, so that it ends at most 40 levels deeper. */
    static final int DEEPEST_CUT = 80;

    static final int DEEPEST_TREE = 128;

    final TreeNode[] waiting = new TreeNode[DEEPEST_TREE];
    final double[] entries = new double[DEEPEST_TREE];

    private final RayCounts counts;
    private Primitive primitive;
    private TreeNode leaf;
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

    /** Tests one primitive and says whether it is nearer than all before. */
    boolean test(Primitive candidate, Ray ray) {
        double candidateDistance = candidate.distance(ray, distance);
        boolean nearer = isNearer(candidate, candidateDistance, primitive, distance);
        if (nearer) {
            primitive = candidate;
            distance = candidateDistance;
        }
        return nearer;
    }

    /** Whether a candidate replaces what was found before: of equally near ones the one that is listed first stays. */
    private static boolean isNearer(Primitive candidate, double candidateDistance, Primitive found, double distance) {
        return candidateDistance < distance
                || (candidateDistance == distance
                        && candidateDistance < Primitive.NO_HIT
                        && (found == null || candidate.order() < found.order()));
    }

    void count(long nodes, long tests) {
        counts.nodes += nodes;
        counts.tests += tests;
    }

    /** Notes the leaf in which the nearest primitive so far was found; null if none holds it. */
    void foundIn(TreeNode node) {
        leaf = node;
    }

    /** Forgets that leaf. */
    public void forgetLeaf() {
        leaf = null;
    }

    /** The leaf in which a nearest primitive was last found, or null if there was none yet. */
    TreeNode leaf() {
        return leaf;
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
