package tompkins.search;

import java.util.Arrays;
import tompkins.primitive.Primitive;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;

/**
 * A region that holds a number of rays: the space between five planes, computed from the rays themselves. It is right
 * for whatever made the rays: lenses, shutters, changes of frame.
 *
 * <p>A plane is kept as a normal n and a bound: no point of any ray has n.x above the bound. A primitive whose least
 * n.x lies above it cannot be hit.
 */
final class PacketFrustum extends Padded {

    private static final int PLANES = 5;

    /** The plane across the rays: all of them lie in front of it. */
    private static final int AHEAD = 4;

    /** Widening against rounding of the starts; primitives and nodes have margins of their own. */
    private static final double MARGIN = 1e-12;

    /** Smallest cosine between a ray and the mean direction; it is not worth bounding wider packets. */
    private static final double LEAST_COSINE = 0.2;

    final double[] normals = new double[3 * PLANES];
    final double[] bounds = new double[PLANES];

    private final double[] cosines = new double[RayPacket.MOST];
    private final double[] inverses = new double[RayPacket.MOST];
    private final double[] slopesE = new double[RayPacket.MOST];
    private final double[] slopesF = new double[RayPacket.MOST];

    private boolean oneStart;
    private double farthest;
    private double farthestAhead;

    /**
     * Bounds the rays of a packet.
     *
     * @return false if they spread too widely; the frustum must not be used then
     */
    boolean enclose(RayPacket rays) {
        int count = rays.count();
        // any axis will do that is close to all rays; the first and the last ray of a packet lie in opposite corners
        double ax = rays.dx[0] + rays.dx[count - 1];
        double ay = rays.dy[0] + rays.dy[count - 1];
        double az = rays.dz[0] + rays.dz[count - 1];
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        if (!(length > LEAST_COSINE)) {
            return false;
        }
        ax /= length;
        ay /= length;
        az /= length;
        // two directions across; the first is made from the two best-conditioned axes
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
        for (int i = 0; i < count; i++) {
            cosines[i] = rays.dx[i] * ax + rays.dy[i] * ay + rays.dz[i] * az;
        }
        for (int i = 0; i < count; i++) {
            inverses[i] = 1 / cosines[i];
        }
        for (int i = 0; i < count; i++) {
            slopesE[i] = (rays.dx[i] * ex + rays.dy[i] * ey + rays.dz[i] * ez) * inverses[i];
        }
        for (int i = 0; i < count; i++) {
            slopesF[i] = (rays.dx[i] * fx + rays.dy[i] * fy + rays.dz[i] * fz) * inverses[i];
        }
        double leastE = Double.POSITIVE_INFINITY;
        double mostE = Double.NEGATIVE_INFINITY;
        double leastF = Double.POSITIVE_INFINITY;
        double mostF = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            if (!(cosines[i] > LEAST_COSINE)) {
                return false;
            }
            double slopeE = slopesE[i];
            double slopeF = slopesF[i];
            leastE = slopeE < leastE ? slopeE : leastE;
            mostE = slopeE > mostE ? slopeE : mostE;
            leastF = slopeF < leastF ? slopeF : leastF;
            mostF = slopeF > mostF ? slopeF : mostF;
        }
        setNormal(0, ex - mostE * ax, ey - mostE * ay, ez - mostE * az);
        setNormal(1, leastE * ax - ex, leastE * ay - ey, leastE * az - ez);
        setNormal(2, fx - mostF * ax, fy - mostF * ay, fz - mostF * az);
        setNormal(3, leastF * ax - fx, leastF * ay - fy, leastF * az - fz);
        setNormal(AHEAD, -ax, -ay, -az);
        boundStarts(rays);
        return true;
    }

    private void setNormal(int plane, double x, double y, double z) {
        normals[3 * plane] = x;
        normals[3 * plane + 1] = y;
        normals[3 * plane + 2] = z;
    }

    /** n.x only falls along a ray, so that its start decides. */
    private void boundStarts(RayPacket rays) {
        Arrays.fill(bounds, Double.NEGATIVE_INFINITY);
        farthest = 0;
        farthestAhead = Double.NEGATIVE_INFINITY;
        oneStart = haveOneStart(rays);
        int starts = oneStart ? 1 : rays.count();
        for (int i = 0; i < starts; i++) {
            double x = rays.x[i];
            double y = rays.y[i];
            double z = rays.z[i];
            for (int plane = 0; plane < PLANES; plane++) {
                bounds[plane] = Math.max(bounds[plane], height(plane, x, y, z));
            }
            farthest = Math.max(farthest, Math.abs(x) + Math.abs(y) + Math.abs(z));
            farthestAhead = Math.max(farthestAhead, -height(AHEAD, x, y, z));
        }
        for (int plane = 0; plane < PLANES; plane++) {
            bounds[plane] += MARGIN * farthest;
        }
        farthestAhead += MARGIN * farthest;
    }

    /** Whether all rays start at one point, as most of those from a pinhole do. */
    private static boolean haveOneStart(RayPacket rays) {
        int same = 0;
        for (int i = 0; i < rays.count(); i++) {
            same += rays.x[i] == rays.x[0] && rays.y[i] == rays.y[0] && rays.z[i] == rays.z[0] ? 1 : 0;
        }
        return same == rays.count();
    }

    /** Whether all rays start at one point. */
    boolean hasOneStart() {
        return oneStart;
    }

    /** The largest |x| + |y| + |z| of a start of a ray. */
    double farthest() {
        return farthest;
    }

    private double height(int plane, double x, double y, double z) {
        return normals[3 * plane] * x + normals[3 * plane + 1] * y + normals[3 * plane + 2] * z;
    }

    /** Whether no ray can meet a primitive. */
    boolean misses(Primitive primitive) {
        for (int plane = 0; plane < PLANES; plane++) {
            int at = 3 * plane;
            if (primitive.conservativeMinimumAlong(normals[at], normals[at + 1], normals[at + 2]) > bounds[plane]) {
                return true;
            }
        }
        return false;
    }

    /** Whether no ray can meet anything in the box of a node. */
    boolean misses(TreeNode node) {
        for (int plane = 0; plane < PLANES; plane++) {
            double least = node.minimumAlong(normals[3 * plane], normals[3 * plane + 1], normals[3 * plane + 2]);
            if (least > bounds[plane]) {
                return true;
            }
        }
        return false;
    }

    /** A lower bound of the distance at which any ray reaches a primitive. */
    double leastDistance(Primitive primitive) {
        int at = 3 * AHEAD;
        return primitive.conservativeMinimumAlong(-normals[at], -normals[at + 1], -normals[at + 2]) - farthestAhead;
    }

    /** A lower bound of the distance at which any ray reaches the box of a node. */
    double leastDistance(TreeNode node) {
        int at = 3 * AHEAD;
        return node.minimumAlong(-normals[at], -normals[at + 1], -normals[at + 2]) - farthestAhead;
    }
}
