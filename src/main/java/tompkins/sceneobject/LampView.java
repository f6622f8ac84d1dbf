package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;

/**
 * What a lamp that stands outside a scene sees of it: a square of cells, each a range of slopes to the right and up.
 */
final class LampView {

    /** Widening of cells and of the view against rounding of slopes, which are 4 at most. */
    private static final double MARGIN = 1e-9;

    /** Least cosine between the middle of the view and its edge. */
    private static final double LEAST_COSINE = 0.3;

    /** Cells in a rectangle, from the first to the last column and row. */
    record Cells(int firstColumn, int lastColumn, int firstRow, int lastRow) {

        int width() {
            return lastColumn - firstColumn + 1;
        }

        int height() {
            return lastRow - firstRow + 1;
        }

        boolean overlaps(int column, int row, int size) {
            return column <= lastColumn && column + size > firstColumn && row <= lastRow && row + size > firstRow;
        }
    }

    private final int side;
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

    private LampView(Vector3dc lamp, Vector3dc forward, Bounds all, int side) {
        this.side = side;
        x = lamp.x();
        y = lamp.y();
        z = lamp.z();
        this.forward = forward;
        right = Vectors.firstAxis(forward);
        up = forward.cross(right, new Vector3d());
        rightX = right.x();
        rightY = right.y();
        rightZ = right.z();
        upX = up.x();
        upY = up.y();
        upZ = up.z();
        forwardX = forward.x();
        forwardY = forward.y();
        forwardZ = forward.z();
        double[] slopes = slopes(all);
        leastU = slopes[0];
        leastV = slopes[2];
        cellU = (slopes[1] - slopes[0]) / side;
        cellV = (slopes[3] - slopes[2]) / side;
        cellsPerU = 1 / cellU;
        cellsPerV = 1 / cellV;
    }

    /**
     * The view of a lamp.
     *
     * @param all a box around what it sees
     * @param side number of columns and of rows
     * @return null if the box reaches beside or behind the lamp
     */
    static LampView of(Vector3dc lamp, Bounds all, int side) {
        Vector3d toCentre = all.centre().sub(lamp);
        if (!(toCentre.length() > 0)) {
            return null;
        }
        Vector3d forward = Vectors.unit(toCentre);
        for (int corner = 0; corner < 8; corner++) {
            Vector3d to = new Vector3d(
                            (corner & 1) == 0 ? all.minX() : all.maxX(),
                            (corner & 2) == 0 ? all.minY() : all.maxY(),
                            (corner & 4) == 0 ? all.minZ() : all.maxZ())
                    .sub(lamp);
            if (!(to.dot(forward) > LEAST_COSINE * to.length())) {
                return null;
            }
        }
        return new LampView(lamp, forward, all, side);
    }

    int side() {
        return side;
    }

    boolean isOf(double lampX, double lampY, double lampZ) {
        return x == lampX && y == lampY && z == lampZ;
    }

    /** Least and largest slope to the right, least and largest slope up, under which a box is seen. */
    private double[] slopes(Bounds box) {
        Vector3d centre = box.centre().sub(x, y, z);
        Vector3d half =
                new Vector3d(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ()).mul(0.5);
        double near = centre.dot(forward) - reach(half, forward);
        double far = centre.dot(forward) + reach(half, forward);
        double mostU = centre.dot(right) + reach(half, right);
        double lowU = centre.dot(right) - reach(half, right);
        double mostV = centre.dot(up) + reach(half, up);
        double lowV = centre.dot(up) - reach(half, up);
        return new double[] {
            lowU / (lowU < 0 ? near : far) - MARGIN,
            mostU / (mostU > 0 ? near : far) + MARGIN,
            lowV / (lowV < 0 ? near : far) - MARGIN,
            mostV / (mostV > 0 ? near : far) + MARGIN
        };
    }

    private static double reach(Vector3dc half, Vector3dc axis) {
        return half.x() * Math.abs(axis.x()) + half.y() * Math.abs(axis.y()) + half.z() * Math.abs(axis.z());
    }

    /** A rectangle of cells in which all of a box inside the view is seen. */
    Cells cells(Bounds box) {
        double[] slopes = slopes(box.widened());
        return new Cells(
                inside((slopes[0] - leastU) * cellsPerU),
                inside((slopes[1] - leastU) * cellsPerU),
                inside((slopes[2] - leastV) * cellsPerV),
                inside((slopes[3] - leastV) * cellsPerV));
    }

    private int inside(double place) {
        return (int) Math.max(0, Math.min(side - 1, Math.floor(place)));
    }

    /** Whether a primitive may be seen in a square of cells. */
    boolean isSeen(Primitive primitive, int column, int row, int size) {
        return !(isBeyond(primitive, right, leastU + (column + size) * cellU + MARGIN, 1)
                || isBeyond(primitive, right, leastU + column * cellU - MARGIN, -1)
                || isBeyond(primitive, up, leastV + (row + size) * cellV + MARGIN, 1)
                || isBeyond(primitive, up, leastV + row * cellV - MARGIN, -1));
    }

    /** Whether all of a primitive is seen under a slope above (sign 1) or below (sign -1) a limit. */
    private boolean isBeyond(Primitive primitive, Vector3dc across, double slope, int sign) {
        double nx = sign * (across.x() - slope * forward.x());
        double ny = sign * (across.y() - slope * forward.y());
        double nz = sign * (across.z() - slope * forward.z());
        return primitive.isBeyond(nx, ny, nz, nx * x + ny * y + nz * z);
    }

    /**
     * The cell of a direction, row by row, or -1 outside the view.
     *
     * @param dx unit vector from a place to the lamp
     * @param dy its second component
     * @param dz its third component
     */
    int cell(double dx, double dy, double dz) {
        double ahead = -(dx * forwardX + dy * forwardY + dz * forwardZ);
        if (!(ahead > 0)) {
            return -1;
        }
        double scale = 1 / ahead;
        double u = -(dx * rightX + dy * rightY + dz * rightZ) * scale - leastU;
        double v = -(dx * upX + dy * upY + dz * upZ) * scale - leastV;
        double column = u * cellsPerU;
        double row = v * cellsPerV;
        return column >= 0 && row >= 0 && column < side && row < side ? ((int) row) * side + (int) column : -1;
    }
}
