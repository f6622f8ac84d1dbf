package tompkins.search;

import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/** A node of a bounding-volume tree: a box that holds either two further nodes or a few primitives. */
final class TreeNode {

    /** What {@link #entry} returns for a ray that misses the box. */
    static final double MISSED = Double.POSITIVE_INFINITY;

    /** Factor by which the entry into a box is moved forwards, so that no hit is lost by about ten roundings. */
    private static final double SOONER = 1 - 4e-15;

    private final double minX;
    private final double minY;
    private final double minZ;
    private final double maxX;
    private final double maxY;
    private final double maxZ;

    /** The two halves, null in a leaf. */
    final TreeNode low;

    final TreeNode high;

    /** The primitives of the whole tree, of which a leaf holds some; null in an inner node. */
    final Primitive[] primitives;

    /** Place of the first primitive that the node holds, itself or in its halves. */
    final int from;

    /** Place after the last one. */
    final int to;

    TreeNode(Bounds bounds, TreeNode low, TreeNode high) {
        this(bounds, low, high, null, low.from, high.to);
    }

    TreeNode(Bounds bounds, Primitive[] primitives, int from, int to) {
        this(bounds, null, null, primitives, from, to);
    }

    private TreeNode(Bounds bounds, TreeNode low, TreeNode high, Primitive[] primitives, int from, int to) {
        Bounds wide = bounds.widened();
        minX = wide.minX();
        minY = wide.minY();
        minZ = wide.minZ();
        maxX = wide.maxX();
        maxY = wide.maxY();
        maxZ = wide.maxZ();
        this.low = low;
        this.high = high;
        this.primitives = primitives;
        this.from = from;
        this.to = to;
    }

    /** Number of primitives that the node holds, itself or in its halves. */
    int size() {
        return to - from;
    }

    /**
     * Distance at which a ray enters the box (below 0 if it starts inside), or {@link #MISSED} (Kay and Kajiya 1986). A
     * ray along a plane of the box itself gives 0 times infinity, which no comparison refuses: the box then counts as
     * met, at a distance that is NaN.
     */
    double entry(double x, double y, double z, double inverseX, double inverseY, double inverseZ, double limit) {
        double enterX = ((inverseX > 0 ? minX : maxX) - x) * inverseX;
        double leaveX = ((inverseX > 0 ? maxX : minX) - x) * inverseX;
        double enterY = ((inverseY > 0 ? minY : maxY) - y) * inverseY;
        double leaveY = ((inverseY > 0 ? maxY : minY) - y) * inverseY;
        double enterZ = ((inverseZ > 0 ? minZ : maxZ) - z) * inverseZ;
        double leaveZ = ((inverseZ > 0 ? maxZ : minZ) - z) * inverseZ;
        double enter = SOONER * Math.max(Math.max(enterX, enterY), enterZ);
        double leave = Math.min(Math.min(leaveX, leaveY), leaveZ);
        return enter > leave || leave < 0 || enter > limit ? MISSED : enter;
    }

    /**
     * Where a straight line comes nearer to the box than a distance, in units of the way to another place; above
     * {@link #leaving} if it does not.
     *
     * @param inverseX the inverse of that way
     */
    double coming(double x, double y, double z, double inverseX, double inverseY, double inverseZ, double distance) {
        double enterX = ((inverseX > 0 ? minX - distance : maxX + distance) - x) * inverseX;
        double enterY = ((inverseY > 0 ? minY - distance : maxY + distance) - y) * inverseY;
        double enterZ = ((inverseZ > 0 ? minZ - distance : maxZ + distance) - z) * inverseZ;
        return Math.max(Math.max(enterX, enterY), enterZ);
    }

    /** Where it leaves again; see {@link #coming}. */
    double leaving(double x, double y, double z, double inverseX, double inverseY, double inverseZ, double distance) {
        double leaveX = ((inverseX > 0 ? maxX + distance : minX - distance) - x) * inverseX;
        double leaveY = ((inverseY > 0 ? maxY + distance : minY - distance) - y) * inverseY;
        double leaveZ = ((inverseZ > 0 ? maxZ + distance : minZ - distance) - z) * inverseZ;
        return Math.min(Math.min(leaveX, leaveY), leaveZ);
    }

    /** The least value of n.x over the box. */
    double minimumAlong(double nx, double ny, double nz) {
        return (nx > 0 ? minX : maxX) * nx + (ny > 0 ? minY : maxY) * ny + (nz > 0 ? minZ : maxZ) * nz;
    }
}
