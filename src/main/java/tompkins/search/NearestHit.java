package tompkins.search;

import tompkins.primitive.Primitive;
import tompkins.ray.Contact;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/** The result and the memory of a search for the nearest primitive. One for each thread. */
public final class NearestHit extends Padded {

    /** Below this depth a tree is cut into halves of equal number, so that it ends at most 40 levels deeper. */
    static final int DEEPEST_CUT = 80;

    static final int DEEPEST_TREE = 128;

    /** More than rounding leaves of a distance along a ray, relative to it. */
    private static final double REACH = 1e-9;

    /** The same relative to the coordinates of the start. */
    private static final double LEAST_REACH = 100 * Contact.ROUNDING;

    final TreeNode[] waiting = new TreeNode[DEEPEST_TREE];
    final double[] entries = new double[DEEPEST_TREE];

    private final RayCounts counts;
    private Primitive primitive;
    private double distance;

    /** So far others may lie at the place of the nearest, by more than rounding. */
    private double reach;

    private boolean shared;

    /** The memory of a thread; it counts the nodes and primitives that the thread's searches look at. */
    public NearestHit(RayCounts counts) {
        this.counts = counts;
    }

    /** Starts a search of everything nearer than {@code limit}. */
    void start(double limit) {
        resume(null, limit, limit, false);
    }

    /** Goes on from what an earlier search has found, with its reach and whether that was shared. */
    public void resume(Primitive found, double foundDistance, double foundReach, boolean wasShared) {
        primitive = found;
        distance = foundDistance;
        reach = foundReach;
        shared = wasShared;
    }

    /** Tests one primitive; the nearest stays, or of equally near ones the one that is listed first. */
    void test(Primitive candidate, Ray ray) {
        double candidateDistance = candidate.distance(ray, reach);
        if (candidateDistance < Primitive.NO_HIT && ray.contact != null) {
            candidateDistance = candidate.distanceOff(ray, reach);
        }
        if (candidateDistance < Primitive.NO_HIT) {
            take(candidate, candidateDistance, ray);
        }
    }

    private void take(Primitive candidate, double candidateDistance, Ray ray) {
        if (candidateDistance < distance
                || candidateDistance == distance && (primitive == null || candidate.order() < primitive.order())) {
            reach = candidateDistance + REACH * candidateDistance + LEAST_REACH * Contact.size(ray, 0);
            // if it is very near the ray may start there
            shared = primitive != null && distance <= reach
                    || 2 * candidateDistance < reach
                    || candidate instanceof RotatingGroup group && group.isShared();
            primitive = candidate;
            distance = candidateDistance;
        } else {
            shared = true;
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

    /** The distance up to which something at the place of the nearest primitive may lie; the limit if there is none. */
    public double reach() {
        return reach;
    }

    /** Whether something else may lie at the place of the nearest primitive, or the ray may start there. */
    public boolean isShared() {
        return shared;
    }

    /** Distance of the nearest primitive. */
    public double distance() {
        return distance;
    }
}
