package tompkins.sceneobject;

import tompkins.ray.Ray;

/**
 * A region that holds a number of rays: the space between five planes, worked out from the rays themselves. It is right for
 * whatever made the rays: lenses, shutters, changes of frame.
 *
 * <p>A plane is kept as a normal n and a bound: no point of any ray has n.x above the bound. A primitive whose least n.x lies
 * above it cannot be hit.
 */
final class RayBundle {

    private static final int PLANES = 5;

    /** The plane across the rays: nothing of them lies behind it. */
    private static final int AHEAD = 4;

    /** Widening against rounding, relative to the coordinates. */
    private static final double MARGIN = 1e-12;

    /** Smallest cosine between a ray and the mean direction; wider bundles are not worth bounding. */
    private static final double LEAST_COSINE = 0.2;

    final double[] normals = new double[3 * PLANES];
    final double[] bounds = new double[PLANES];

    private double farthestStart;

    /**
     * Bounds some of an array's rays, from one place to before another.
     *
     * @return false if they spread too widely; the bundle must not be used then
     */
    boolean enclose(Ray[] rays, int from, int to) {
        double ax = 0;
        double ay = 0;
        double az = 0;
        for (int i = from; i < to; i++) {
            ax += rays[i].dx;
            ay += rays[i].dy;
            az += rays[i].dz;
        }
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        if (!(length > LEAST_COSINE * (to - from))) {
            return false;
        }
        ax /= length;
        ay /= length;
        az /= length;
        // two directions across: the first is made of the two axes that are best conditioned
        boolean alongX = Math.abs(ax) > 0.7;
        double ex = alongX ? -ay : 0;
        double ey = alongX ? ax : -az;
        double ez = alongX ? 0 : ay;
        double across = Math.sqrt(ex * ex + ey * ey + ez * ez);
        ex /= across;
        ey /= across;
        ez /= across;
        double fx = ay * ez - az * ey;
        double fy = az * ex - ax * ez;
        double fz = ax * ey - ay * ex;
        double leastE = Double.POSITIVE_INFINITY;
        double mostE = Double.NEGATIVE_INFINITY;
        double leastF = Double.POSITIVE_INFINITY;
        double mostF = Double.NEGATIVE_INFINITY;
        for (int i = from; i < to; i++) {
            Ray ray = rays[i];
            double cosine = ray.dx * ax + ray.dy * ay + ray.dz * az;
            if (!(cosine > LEAST_COSINE)) {
                return false;
            }
            double slopeE = (ray.dx * ex + ray.dy * ey + ray.dz * ez) / cosine;
            double slopeF = (ray.dx * fx + ray.dy * fy + ray.dz * fz) / cosine;
            leastE = slopeE < leastE ? slopeE : leastE;
            mostE = slopeE > mostE ? slopeE : mostE;
            leastF = slopeF < leastF ? slopeF : leastF;
            mostF = slopeF > mostF ? slopeF : mostF;
        }
        mostE += MARGIN;
        leastE -= MARGIN;
        mostF += MARGIN;
        leastF -= MARGIN;
        setNormal(0, ex - mostE * ax, ey - mostE * ay, ez - mostE * az);
        setNormal(1, leastE * ax - ex, leastE * ay - ey, leastE * az - ez);
        setNormal(2, fx - mostF * ax, fy - mostF * ay, fz - mostF * az);
        setNormal(3, leastF * ax - fx, leastF * ay - fy, leastF * az - fz);
        setNormal(AHEAD, -ax, -ay, -az);
        boundStarts(rays, from, to);
        return true;
    }

    private void setNormal(int plane, double x, double y, double z) {
        normals[3 * plane] = x;
        normals[3 * plane + 1] = y;
        normals[3 * plane + 2] = z;
    }

    /** Along a ray n.x only falls, so that its start decides. */
    private void boundStarts(Ray[] rays, int from, int to) {
        Ray first = rays[from];
        double farthest = Math.abs(first.x) + Math.abs(first.y) + Math.abs(first.z);
        for (int plane = 0; plane < PLANES; plane++) {
            bounds[plane] = height(plane, first);
        }
        farthestStart = -bounds[AHEAD];
        for (int i = from + 1; i < to; i++) {
            Ray ray = rays[i];
            // all rays of a pinhole start at one point, usually
            if (ray.x == first.x && ray.y == first.y && ray.z == first.z) {
                continue;
            }
            farthest = Math.max(farthest, Math.abs(ray.x) + Math.abs(ray.y) + Math.abs(ray.z));
            for (int plane = 0; plane < PLANES; plane++) {
                bounds[plane] = Math.max(bounds[plane], height(plane, ray));
            }
            farthestStart = Math.max(farthestStart, -height(AHEAD, ray));
        }
        for (int plane = 0; plane < PLANES; plane++) {
            bounds[plane] += MARGIN * (1 + farthest);
        }
        farthestStart += MARGIN * (1 + farthest);
    }

    private double height(int plane, Ray ray) {
        return normals[3 * plane] * ray.x + normals[3 * plane + 1] * ray.y + normals[3 * plane + 2] * ray.z;
    }

    /** Whether no ray of the bundle can meet a primitive. */
    boolean misses(Primitive primitive) {
        for (int plane = 0; plane < PLANES; plane++) {
            int at = 3 * plane;
            if (primitive.isBeyond(normals[at], normals[at + 1], normals[at + 2], bounds[plane])) {
                return true;
            }
        }
        return false;
    }

    /** Whether no ray of the bundle can meet anything in the box of a node. */
    boolean misses(TreeNode node) {
        for (int plane = 0; plane < PLANES; plane++) {
            double least = node.least(normals[3 * plane], normals[3 * plane + 1], normals[3 * plane + 2]);
            if (least > bounds[plane]) {
                return true;
            }
        }
        return false;
    }

    /** A distance that no ray of the bundle falls below before it reaches the box of a node. */
    double leastDistance(TreeNode node) {
        int at = 3 * AHEAD;
        return node.least(-normals[at], -normals[at + 1], -normals[at + 2]) - farthestStart;
    }
}
