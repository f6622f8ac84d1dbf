package tompkins.sceneobject;

/** A node of a bounding-volume tree: a box that holds either two further nodes or a few primitives. */
final class TreeNode {

    /** What {@link #entry} returns for a ray that misses the box. */
    static final double MISSED = Double.POSITIVE_INFINITY;

    /** Factor that keeps rounding in the slab test from losing a hit (three roundings on each side). */
    private static final double ROUNDING = 1 + 8e-16;

    private final double minX;
    private final double minY;
    private final double minZ;
    private final double maxX;
    private final double maxY;
    private final double maxZ;

    /** The two halves, null in a leaf. */
    final TreeNode low;

    final TreeNode high;

    /** What a leaf holds, null in an inner node. */
    final Primitive[] primitives;

    TreeNode(Bounds bounds, TreeNode low, TreeNode high) {
        this(bounds, low, high, null);
    }

    TreeNode(Bounds bounds, Primitive[] primitives) {
        this(bounds, null, null, primitives);
    }

    private TreeNode(Bounds bounds, TreeNode low, TreeNode high, Primitive[] primitives) {
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
    }

    /**
     * Distance at which a ray enters the box (below 0 if it starts inside), or {@link #MISSED}. Along an axis that the ray
     * does not follow, the distances to the two sides are opposite infinities or NaN unless it passes outside; their sum is
     * then NaN, and the axis does not count.
     */
    double entry(double x, double y, double z, double inverseX, double inverseY, double inverseZ, double limit) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        double low = (minX - x) * inverseX;
        double high = (maxX - x) * inverseX;
        double sum = low + high;
        if (!Double.isNaN(sum)) {
            enter = low < high ? low : high;
            leave = low < high ? high : low;
        }
        low = (minY - y) * inverseY;
        high = (maxY - y) * inverseY;
        sum = low + high;
        if (!Double.isNaN(sum)) {
            double near = low < high ? low : high;
            double far = low < high ? high : low;
            enter = near > enter ? near : enter;
            leave = far < leave ? far : leave;
        }
        low = (minZ - z) * inverseZ;
        high = (maxZ - z) * inverseZ;
        sum = low + high;
        if (!Double.isNaN(sum)) {
            double near = low < high ? low : high;
            double far = low < high ? high : low;
            enter = near > enter ? near : enter;
            leave = far < leave ? far : leave;
        }
        return enter > leave * ROUNDING || leave < 0 || enter > limit ? MISSED : enter;
    }

    /** The least value of n.x over the box. */
    double least(double nx, double ny, double nz) {
        return (nx > 0 ? minX : maxX) * nx + (ny > 0 ? minY : maxY) * ny + (nz > 0 ? minZ : maxZ) * nz;
    }
}
