package tompkins.sceneobject;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;

/**
 * The primitives as a lamp sees them: a grid of directions, each with the primitives that stand there. A shadow ray
 * asks only those of its direction (the light buffer of Haines and Greenberg 1986). Built once for a scene and a lamp
 * that stands outside it.
 */
public final class LightGrid {

    private static final int DEPTH = 7;

    private static final int SIDE = 1 << DEPTH;

    /** Widening of cells and of the grid against rounding of slopes, which are 4 at most. */
    private static final double MARGIN = 1e-9;

    /** More primitives than this are left to the tree: the grid would be large, and a cell long. */
    private static final int MOST_PRIMITIVES = 20_000;

    /** With more primitives than this in the mean cell the tree is faster. */
    private static final int MOST_IN_MEAN_CELL = 24;

    private static final Occluder[] NONE = {};

    private final double x;
    private final double y;
    private final double z;
    private final Vector3dc right;
    private final Vector3dc up;
    private final Vector3dc forward;
    private final double leastU;
    private final double leastV;
    private final double cellU;
    private final double cellV;
    private final double cellsPerU;
    private final double cellsPerV;

    // the axes as plain numbers, for every shadow ray asks for them
    private final double rightX;
    private final double rightY;
    private final double rightZ;
    private final double upX;
    private final double upY;
    private final double upZ;
    private final double forwardX;
    private final double forwardY;
    private final double forwardZ;

    private final Primitive[] everywhere;
    private final boolean complete;
    private int entries;
    private final Occluder[][] cells = new Occluder[SIDE * SIDE][];

    private LightGrid(Vector3dc position, Vector3dc forward, ObjectTree objects, double[] extent) {
        x = position.x();
        y = position.y();
        z = position.z();
        this.forward = forward;
        right = Vectors.firstAxis(forward);
        up = forward.cross(right, new Vector3d());
        leastU = extent[0];
        leastV = extent[2];
        cellU = (extent[1] - extent[0]) / SIDE;
        cellV = (extent[3] - extent[2]) / SIDE;
        cellsPerU = 1 / cellU;
        cellsPerV = 1 / cellV;
        rightX = right.x();
        rightY = right.y();
        rightZ = right.z();
        upX = up.x();
        upY = up.y();
        upZ = up.z();
        forwardX = forward.x();
        forwardY = forward.y();
        forwardZ = forward.z();
        everywhere = objects.unbounded().toArray(Primitive[]::new);
        complete = fill(
                0,
                0,
                DEPTH,
                objects.bounded().stream()
                        .map(primitive -> new Occluder(primitive, position))
                        .toList());
    }

    /**
     * The grid of a lamp, or null if none can be made: the lamp stands among the primitives, or there are too many of
     * them, or none.
     */
    public static LightGrid of(Vector3dc position, ObjectTree objects) {
        List<Primitive> bounded = objects.bounded();
        if (bounded.isEmpty() || bounded.size() > MOST_PRIMITIVES) {
            return null;
        }
        Bounds all = bounded.get(0).bounds();
        for (Primitive primitive : bounded) {
            all = all.with(primitive.bounds());
        }
        Vector3d toCentre = all.centre().sub(position);
        if (!(toCentre.length() > 0)) {
            return null;
        }
        Vector3d forward = Vectors.unit(toCentre);
        double[] extent = extent(all, position, forward);
        if (extent == null) {
            return null;
        }
        LightGrid grid = new LightGrid(position, forward, objects, extent);
        return grid.complete ? grid : null;
    }

    /**
     * Range of the slopes to the right and up under which a box is seen; null if it reaches beside or behind the lamp.
     */
    private static double[] extent(Bounds box, Vector3dc position, Vector3dc forward) {
        Vector3d right = Vectors.firstAxis(forward);
        Vector3d up = forward.cross(right, new Vector3d());
        double[] extent = {
            Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
        };
        for (int corner = 0; corner < 8; corner++) {
            Vector3d to = new Vector3d(
                            (corner & 1) == 0 ? box.minX() : box.maxX(),
                            (corner & 2) == 0 ? box.minY() : box.maxY(),
                            (corner & 4) == 0 ? box.minZ() : box.maxZ())
                    .sub(position);
            double ahead = to.dot(forward);
            if (!(ahead > 0.3 * to.length())) {
                return null;
            }
            extent[0] = Math.min(extent[0], to.dot(right) / ahead - MARGIN);
            extent[1] = Math.max(extent[1], to.dot(right) / ahead + MARGIN);
            extent[2] = Math.min(extent[2], to.dot(up) / ahead - MARGIN);
            extent[3] = Math.max(extent[3], to.dot(up) / ahead + MARGIN);
        }
        return extent;
    }

    /**
     * Hands primitives down to the quarters of a square of cells that they can be seen in; false if they are too many.
     */
    private boolean fill(int column, int row, int depth, List<Occluder> occluders) {
        if (occluders.isEmpty()) {
            return true;
        }
        if (depth == 0) {
            cells[row * SIDE + column] = occluders.toArray(Occluder[]::new);
            entries += occluders.size();
            return entries <= MOST_IN_MEAN_CELL * cells.length;
        }
        int half = 1 << (depth - 1);
        for (int quarter = 0; quarter < 4; quarter++) {
            int first = column + (quarter & 1) * half;
            int lowest = row + (quarter >> 1) * half;
            List<Occluder> seen = new ArrayList<>();
            for (Occluder occluder : occluders) {
                if (isSeen(occluder.primitive(), first, lowest, half)) {
                    seen.add(occluder);
                }
            }
            if (!fill(first, lowest, depth - 1, seen)) {
                return false;
            }
        }
        return true;
    }

    private boolean isSeen(Primitive primitive, int column, int row, int side) {
        return !(isBeyond(primitive, right, leastU + (column + side) * cellU + MARGIN, 1)
                || isBeyond(primitive, right, leastU + column * cellU - MARGIN, -1)
                || isBeyond(primitive, up, leastV + (row + side) * cellV + MARGIN, 1)
                || isBeyond(primitive, up, leastV + row * cellV - MARGIN, -1));
    }

    /** Whether all of a primitive is seen under a slope above (sign 1) or below (sign -1) a limit. */
    private boolean isBeyond(Primitive primitive, Vector3dc across, double slope, int sign) {
        double nx = sign * (across.x() - slope * forward.x());
        double ny = sign * (across.y() - slope * forward.y());
        double nz = sign * (across.z() - slope * forward.z());
        return primitive.isBeyond(nx, ny, nz, nx * x + ny * y + nz * z);
    }

    /** Whether this is the grid of the lamp at (x, y, z). */
    public boolean isOf(double lampX, double lampY, double lampZ) {
        return x == lampX && y == lampY && z == lampZ;
    }

    /**
     * Whether something throws a shadow on a hit.
     *
     * @param dx unit vector from the hit to the lamp
     * @param dy its second component
     * @param dz its third component
     * @param limit distance of the lamp
     * @param memory for the ray
     * @param counts takes note of the work
     */
    public boolean shadows(Hit from, double dx, double dy, double dz, double limit, Ray memory, RayCounts counts) {
        Ray ray = null;
        int tests = 0;
        boolean shadow = false;
        for (int i = 0; i < everywhere.length && !shadow; i++) {
            if (!everywhere[i].surelyMisses(from, dx, dy, dz)) {
                ray = ray == null ? memory.setShadow(from, dx, dy, dz) : ray;
                shadow = everywhere[i].shadows(ray, limit);
                tests++;
            }
        }
        Occluder[] seen = shadow ? NONE : cell(dx, dy, dz);
        for (int i = 0; i < seen.length && !shadow; i++) {
            if (seen[i].isNear(dx, dy, dz) && !seen[i].primitive().surelyMisses(from, dx, dy, dz)) {
                ray = ray == null ? memory.setShadow(from, dx, dy, dz) : ray;
                shadow = seen[i].primitive().shadows(ray, limit);
                tests++;
            }
        }
        counts.tests += tests;
        return shadow;
    }

    private Occluder[] cell(double dx, double dy, double dz) {
        double ahead = -(dx * forwardX + dy * forwardY + dz * forwardZ);
        if (!(ahead > 0)) {
            return NONE;
        }
        double scale = 1 / ahead;
        double u = -(dx * rightX + dy * rightY + dz * rightZ) * scale - leastU;
        double v = -(dx * upX + dy * upY + dz * upZ) * scale - leastV;
        double column = u * cellsPerU;
        double row = v * cellsPerV;
        if (!(column >= 0 && row >= 0 && column < SIDE && row < SIDE)) {
            return NONE;
        }
        Occluder[] seen = cells[((int) row) * SIDE + (int) column];
        return seen == null ? NONE : seen;
    }
}
