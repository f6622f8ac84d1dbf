package tompkins.sceneobject;

import tompkins.ray.Ray;

/**
 * The few primitives that a block of neighbouring rays can meet, found once for all of them. Searching them gives the same
 * result as searching everything, several times faster. One for each thread, used again for every block.
 */
public final class Candidates {

    /** With more candidates than this the tree is faster. */
    private static final int MOST = 24;

    private final RayBundle bundle = new RayBundle();
    private final TreeNode[] waiting = new TreeNode[NearestHit.DEEPEST_TREE];
    private final Primitive[] found = new Primitive[MOST];
    private int count;

    /**
     * Looks for the primitives that some rays can meet.
     *
     * @param objects all primitives of the frame
     * @param rays the rays; only the first {@code rayCount} count
     * @param rayCount number of rays
     * @return false if the rays spread too widely, or can meet too many primitives; search the tree instead
     */
    public boolean find(ObjectTree objects, Ray[] rays, int rayCount) {
        count = 0;
        if (rayCount == 0 || !bundle.enclose(rays, 0, rayCount)) {
            return false;
        }
        for (Primitive primitive : objects.listed()) {
            if (!add(primitive)) {
                return false;
            }
        }
        return objects.root() == null || searchTree(objects.root());
    }

    private boolean searchTree(TreeNode root) {
        int open = 0;
        waiting[open++] = root;
        while (open > 0) {
            TreeNode node = waiting[--open];
            if (bundle.misses(node)) {
                continue;
            }
            if (node.primitives == null) {
                waiting[open++] = node.low;
                waiting[open++] = node.high;
                continue;
            }
            for (Primitive primitive : node.primitives) {
                if (!add(primitive)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean add(Primitive primitive) {
        if (bundle.misses(primitive)) {
            return true;
        }
        if (count == MOST) {
            return false;
        }
        found[count++] = primitive;
        return true;
    }

    /** Searches the nearest candidate that a ray hits; whether there is one. */
    public boolean nearest(Ray ray, NearestHit nearest) {
        Primitive primitive = null;
        double distance = Primitive.NO_HIT;
        for (int i = 0; i < count; i++) {
            Primitive candidate = found[i];
            double candidateDistance = candidate.distance(ray, distance);
            if (NearestHit.isNearer(candidate, candidateDistance, primitive, distance)) {
                primitive = candidate;
                distance = candidateDistance;
            }
        }
        nearest.end(primitive, distance);
        nearest.count(0, count);
        return primitive != null;
    }
}
