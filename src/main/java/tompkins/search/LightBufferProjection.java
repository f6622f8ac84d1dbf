package tompkins.search;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/**
 * What a lamp that stands outside a scene sees of it: a square of cells, each a range of slopes to the right and up.
 */
final class LightBufferProjection {

    /** Widening of cells and of the view against rounding of slopes, which are 4 at most. */
    private static final double MARGIN = 1e-7;

    /** Least cosine between the middle of the view and its edge. */
    private static final double LEAST_COSINE = 0.3;

    /** Least sine of an angle that counts as more than 0. */
    private static final double LEAST_SINE = 1e-3;

    /** Number of columns of cells, and of rows. */
    static final int SIDE = 128;

    /** Number of columns of parts in a cell, and of rows. */
    static final int PARTS = 128;

    /** What {@link #part} returns outside the view. */
    static final int OUTSIDE = -1;

    private static final int ALL_PARTS = SIDE * PARTS;

    /** A rectangle of parts of cells, from the first to the last column and row of them. */
    record Rectangle(int firstColumn, int lastColumn, int firstRow, int lastRow) {

        int firstCellColumn() {
            return firstColumn / PARTS;
        }

        int lastCellColumn() {
            return lastColumn / PARTS;
        }

        int firstCellRow() {
            return firstRow / PARTS;
        }

        int lastCellRow() {
            return lastRow / PARTS;
        }

        /** What this and another have in common; empty if the last place lies before the first. */
        Rectangle and(Rectangle other) {
            return new Rectangle(
                    Math.max(firstColumn, other.firstColumn),
                    Math.min(lastColumn, other.lastColumn),
                    Math.max(firstRow, other.firstRow),
                    Math.min(lastRow, other.lastRow));
        }

        boolean isEmpty() {
            return lastColumn < firstColumn || lastRow < firstRow;
        }

        /** Number of columns of cells that it reaches into. */
        int width() {
            return lastCellColumn() - firstCellColumn() + 1;
        }

        /** Number of rows of cells that it reaches into. */
        int height() {
            return lastCellRow() - firstCellRow() + 1;
        }

        /** Whether it reaches into a square of cells. */
        boolean overlaps(int column, int row, int size) {
            return column <= lastCellColumn()
                    && column + size > firstCellColumn()
                    && row <= lastCellRow()
                    && row + size > firstCellRow();
        }
    }

    /**
     * A strip of the view, which holds something long: those slopes u to the right and v up for which {@code u perU + v
     * perV} lies between two limits.
     */
    record Strip(double perU, double perV, double least, double most) {}

    /** The numbers between two limits. */
    private record Range(double least, double most) {

        Range and(Range other) {
            return new Range(Math.max(least, other.least), Math.min(most, other.most));
        }

        Range times(double factor) {
            return factor > 0 ? new Range(least * factor, most * factor) : new Range(most * factor, least * factor);
        }

        Range minus(Range other) {
            return new Range(least - other.most, most - other.least);
        }
    }

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
    private final double partsPerU;
    private final double partsPerV;

    // the axes as plain numbers, because every shadow ray asks for them
    private final double rightX;
    private final double rightY;
    private final double rightZ;
    private final double upX;
    private final double upY;
    private final double upZ;
    private final double forwardX;
    private final double forwardY;
    private final double forwardZ;

    private LightBufferProjection(Vector3dc lamp, Vector3dc forward, Bounds all) {
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
        Range slopesU = slopes(all, right);
        Range slopesV = slopes(all, up);
        leastU = slopesU.least;
        leastV = slopesV.least;
        cellU = (slopesU.most - slopesU.least) / SIDE;
        cellV = (slopesV.most - slopesV.least) / SIDE;
        partsPerU = PARTS / cellU;
        partsPerV = PARTS / cellV;
    }

    /**
     * The view of a lamp.
     *
     * @param all a box around what it sees
     * @return null if the box reaches beside or behind the lamp
     */
    static LightBufferProjection of(Vector3dc lamp, Bounds all) {
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
        return new LightBufferProjection(lamp, forward, all);
    }

    /** The slopes under which a box is seen, in a direction across the view. */
    private Range slopes(Bounds box, Vector3dc across) {
        Range ahead = extent(box, forward);
        Range sideways = extent(box, across);
        return new Range(
                sideways.least / (sideways.least < 0 ? ahead.least : ahead.most) - MARGIN,
                sideways.most / (sideways.most > 0 ? ahead.least : ahead.most) + MARGIN);
    }

    /** From where to where a box reaches in a direction, seen from the lamp. */
    private Range extent(Bounds box, Vector3dc direction) {
        double centre = box.centre().sub(x, y, z).dot(direction);
        double half = 0.5
                * ((box.maxX() - box.minX()) * Math.abs(direction.x())
                        + (box.maxY() - box.minY()) * Math.abs(direction.y())
                        + (box.maxZ() - box.minZ()) * Math.abs(direction.z()));
        return new Range(centre - half, centre + half);
    }

    /** The slopes under which a primitive is seen: those of its box, narrowed where the primitive is narrower. */
    private Range slopes(Primitive primitive, Bounds box, Vector3dc across) {
        Range range = slopes(box, across);
        double far = extent(box, forward).most;
        return new Range(
                range.least + gap(primitive, across, range.least, 1) / far - MARGIN,
                range.most - gap(primitive, across, range.most, -1) / far + MARGIN);
    }

    /**
     * The rectangle in which a primitive is seen, which stands in the view.
     *
     * @param box its bounds, widened
     */
    Rectangle rectangle(Primitive primitive, Bounds box) {
        return rectangle(slopes(primitive, box, right), slopes(primitive, box, up));
    }

    private Rectangle rectangle(Range u, Range v) {
        return new Rectangle(
                limited((u.least - leastU) * partsPerU),
                limited((u.most - leastU) * partsPerU),
                limited((v.least - leastV) * partsPerV),
                limited((v.most - leastV) * partsPerV));
    }

    /** The nearest place of a part that lies in the view. */
    private static int limited(double place) {
        return (int) Math.max(0, Math.min(ALL_PARTS - 1, Math.floor(place)));
    }

    /**
     * The strip in which a primitive is seen, or null if it is not long, or if the lamp sees it from its end.
     *
     * @param box its bounds, widened
     */
    Strip strip(Primitive primitive, Bounds box) {
        Vector3d axis = primitive.longAxis();
        if (axis == null) {
            return null;
        }
        Vector3d centre = box.centre().sub(x, y, z);
        // how its slopes change along it
        Vector3d change = axis.fma(-axis.dot(forward) / centre.dot(forward), centre, new Vector3d());
        double perU = -change.dot(up);
        double perV = change.dot(right);
        double length = Math.hypot(perU, perV);
        if (!(length > LEAST_SINE * axis.length())) {
            return null;
        }
        perU /= length;
        perV /= length;
        Range range = slopes(primitive, box, right.mul(perU, new Vector3d()).fma(perV, up));
        return new Strip(perU, perV, range.least, range.most);
    }

    /** The rectangle around that part of a strip that lies in some rows of a column of cells; it may be empty. */
    Rectangle rectangle(Strip strip, int column, int row, int rows) {
        Range u = new Range(leastU + column * cellU, leastU + (column + 1) * cellU);
        Range v = new Range(leastV + row * cellV, leastV + (row + rows) * cellV);
        Range both = new Range(strip.least - MARGIN, strip.most + MARGIN);
        if (Math.abs(strip.perV) > LEAST_SINE) {
            v = v.and(both.minus(u.times(strip.perU)).times(1 / strip.perV));
        }
        if (Math.abs(strip.perU) > LEAST_SINE) {
            u = u.and(both.minus(v.times(strip.perV)).times(1 / strip.perU));
        }
        return rectangle(u, v);
    }

    /** Whether a primitive may be seen in a square of cells. */
    boolean isSeen(Primitive primitive, int column, int row, int size) {
        return !(gap(primitive, right, leastU + (column + size) * cellU + MARGIN, 1) > 0
                || gap(primitive, right, leastU + column * cellU - MARGIN, -1) > 0
                || gap(primitive, up, leastV + (row + size) * cellV + MARGIN, 1) > 0
                || gap(primitive, up, leastV + row * cellV - MARGIN, -1) > 0);
    }

    /**
     * How far across the view all of a primitive stands from the plane of a slope, above it (sign 1) or below it (sign
     * -1); 0 if not all does.
     */
    private double gap(Primitive primitive, Vector3dc across, double slope, int sign) {
        double nx = sign * (across.x() - slope * forward.x());
        double ny = sign * (across.y() - slope * forward.y());
        double nz = sign * (across.z() - slope * forward.z());
        return Math.max(0, primitive.conservativeMinimumAlong(nx, ny, nz) - (nx * x + ny * y + nz * z));
    }

    /**
     * The part of a cell that a direction belongs to: its row among all in the upper half of the bits, its column in
     * the lower; {@link #OUTSIDE} the view.
     *
     * @param dx unit vector from a place to the lamp
     * @param dy its second component
     * @param dz its third component
     */
    int part(double dx, double dy, double dz) {
        double ahead = -(dx * forwardX + dy * forwardY + dz * forwardZ);
        if (!(ahead > 0)) {
            return OUTSIDE;
        }
        double scale = 1 / ahead;
        double u = -(dx * rightX + dy * rightY + dz * rightZ) * scale - leastU;
        double v = -(dx * upX + dy * upY + dz * upZ) * scale - leastV;
        double column = u * partsPerU;
        double row = v * partsPerV;
        return column >= 0 && row >= 0 && column < ALL_PARTS && row < ALL_PARTS
                ? (int) row << Short.SIZE | (int) column
                : OUTSIDE;
    }

    /** The cell of a part of it, row by row. */
    static int cell(int part) {
        return (part >> Short.SIZE) / PARTS * SIDE + (part & 0xffff) / PARTS;
    }
}
