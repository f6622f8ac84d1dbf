package tompkins.search;

import java.util.function.Function;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.primitive.Bounds;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Primitive;

/**
 * What a lamp outside a scene sees of it, at rest or on a piece of its way: a square of cells, each a range of slopes
 * to the right and up.
 */
final class LightBufferProjection {

    /** Widening of cells. */
    private static final double MARGIN = LampProjection.MARGIN;

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
    }

    /**
     * A strip of the view, which holds something long: those slopes u to the right and v up for which {@code u perU + v
     * perV} lies between two limits.
     */
    record Strip(double perU, double perV, double least, double most) {}

    /** Where the lamp begins and ends its way; one place if it rests. */
    private final LampProjection[] places;

    private final double length;
    private final Vector3d right;
    private final Vector3d up;
    private final Vector3d forward;
    private final double leastU;
    private final double leastV;
    private final double cellU;
    private final double cellV;
    private final double partsPerU;
    private final double partsPerV;

    // what the whole way does to slopes
    private final double shiftU;
    private final double shiftV;
    private final double approach;

    private LightBufferProjection(LampProjection[] places, Vector3d forward, Bounds all) {
        this.places = places;
        this.forward = forward;
        right = Vectors.firstAxis(forward);
        up = forward.cross(right, new Vector3d());
        Interval slopesU = slopes(place -> place.slopes(all, right));
        Interval slopesV = slopes(place -> place.slopes(all, up));
        leastU = slopesU.least();
        leastV = slopesV.least();
        cellU = (slopesU.most() - slopesU.least()) / SIDE;
        cellV = (slopesV.most() - slopesV.least()) / SIDE;
        partsPerU = PARTS / cellU;
        partsPerV = PARTS / cellV;
        LampProjection last = places[places.length - 1];
        length = last.place().distance(places[0].place());
        shiftU = last.offset().dot(right);
        shiftV = last.offset().dot(up);
        approach = last.offset().dot(forward);
    }

    /**
     * The view of a lamp that goes straight on from one place to another, which may be the same.
     *
     * @param all a box around what it sees
     * @return null if the box reaches beside or behind the lamp, or is nearer than the length of the way
     */
    static LightBufferProjection of(Vector3dc from, Vector3dc to, Bounds all) {
        Vector3d toCentre = all.centre().sub(from);
        if (!(toCentre.length() > 0)) {
            return null;
        }
        Vector3d forward = Vectors.unit(toCentre);
        LampProjection first = LampProjection.first(from, forward);
        LampProjection[] places = from.equals(to)
                ? new LampProjection[] {first}
                : new LampProjection[] {first, first.next(to, toCentre.dot(forward))};
        for (LampProjection place : places) {
            if (!place.faces(all, from.distance(to))) {
                return null;
            }
        }
        return new LightBufferProjection(places, forward, all);
    }

    /** The range of slopes under which something is seen from all places. */
    private Interval slopes(Function<LampProjection, Interval> from) {
        Interval all = from.apply(places[0]);
        for (int i = 1; i < places.length; i++) {
            all = all.with(from.apply(places[i]));
        }
        return all;
    }

    /** A lower bound of the distance of a box from the lamp, wherever on its way it is; 0 or more. */
    float leastDistance(Bounds box) {
        double least = Double.POSITIVE_INFINITY;
        for (LampProjection place : places) {
            double rounding = Primitive.SLACK * (box.farthest() + place.place().length());
            least = Math.min(least, box.distance(place.place()) - rounding);
        }
        return Math.max(0, Math.nextDown((float) (least - length / 2)));
    }

    /**
     * The rectangle in which a primitive is seen, which stands in the view.
     *
     * @param box its bounds, widened
     */
    Rectangle rectangle(Primitive primitive, Bounds box) {
        return rectangle(
                slopes(place -> place.slopes(primitive, box, right)),
                slopes(place -> place.slopes(primitive, box, up)));
    }

    private Rectangle rectangle(Interval u, Interval v) {
        return new Rectangle(
                limited((u.least() - leastU) * partsPerU),
                limited((u.most() - leastU) * partsPerU),
                limited((v.least() - leastV) * partsPerV),
                limited((v.most() - leastV) * partsPerV));
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
        Vector3d axis = primitive instanceof CylinderPrimitive rod ? rod.longAxis() : null;
        if (axis == null) {
            return null;
        }
        Vector3d centre = box.centre().sub(places[0].place());
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
        Vector3d across = right.mul(perU, new Vector3d()).fma(perV, up);
        Interval range = slopes(place -> place.slopes(primitive, box, across));
        return new Strip(perU, perV, range.least(), range.most());
    }

    /** The rectangle around that part of a strip that lies in some rows of a column of cells; it may be empty. */
    Rectangle rectangle(Strip strip, int column, int row, int rows) {
        Interval u = new Interval(leastU + column * cellU, leastU + (column + 1) * cellU);
        Interval v = new Interval(leastV + row * cellV, leastV + (row + rows) * cellV);
        Interval both = new Interval(strip.least - MARGIN, strip.most + MARGIN);
        if (Math.abs(strip.perV) > LEAST_SINE) {
            v = v.and(both.minus(u.times(strip.perU)).times(1 / strip.perV));
        }
        if (Math.abs(strip.perU) > LEAST_SINE) {
            u = u.and(both.minus(v.times(strip.perV)).times(1 / strip.perU));
        }
        return rectangle(u, v);
    }

    /**
     * The part of a cell that a direction belongs to: its row among all in the upper half of the bits, its column in
     * the lower; {@link #OUTSIDE} the view.
     *
     * @param dx unit vector from a place to the lamp
     * @param dy its second component
     * @param dz its third component
     * @param fraction the part of its way that the lamp has covered, from 0 to 1
     */
    int part(double dx, double dy, double dz, double fraction) {
        double ahead = -(dx * forward.x + dy * forward.y + dz * forward.z);
        if (!(ahead > 0)) {
            return OUTSIDE;
        }
        double scale = (1 - fraction * approach) / ahead;
        double u = fraction * shiftU - (dx * right.x + dy * right.y + dz * right.z) * scale - leastU;
        double v = fraction * shiftV - (dx * up.x + dy * up.y + dz * up.z) * scale - leastV;
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
