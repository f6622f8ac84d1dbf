package tompkins.search;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;

/**
 * A place of a lamp outside a scene, and the slopes under which objects are seen from there: how far they lie across
 * the view for each unit of length ahead.
 *
 * <p>Slopes are given as if the lamp had stayed at the first place of its way and saw the same point of one plane
 * across the view: what lies in that plane has the same slopes from all places, and other objects nearly the same. As
 * the lamp moves on straight, each slope only grows or only falls, so that the slopes at two places bound those between
 * them.
 *
 * @param place where the lamp is
 * @param forward unit vector ahead
 * @param offset from the first place to this one, divided by the distance between the first place and the plane
 */
record LampProjection(Vector3dc place, Vector3dc forward, Vector3dc offset) {

    /** Widening against rounding of slopes, which are 4 at most. */
    static final double MARGIN = 1e-7;

    /** Least cosine between the middle of the view and its edge. */
    private static final double LEAST_COSINE = 0.3;

    /** The first place of a lamp. */
    static LampProjection first(Vector3dc place, Vector3dc forward) {
        return new LampProjection(place, forward, new Vector3d());
    }

    /**
     * Another place.
     *
     * @param depth distance of the plane from this one
     */
    LampProjection next(Vector3dc next, double depth) {
        return new LampProjection(
                next, forward, next.sub(place, new Vector3d()).div(depth).add(offset));
    }

    /** Whether a box lies well in front of the lamp, and not nearer than a distance. */
    boolean faces(Bounds box, double least) {
        for (Vector3d corner : box.corners()) {
            Vector3d to = corner.sub(place);
            double ahead = to.dot(forward);
            if (!(ahead > LEAST_COSINE * to.length() && ahead >= least)) {
                return false;
            }
        }
        return true;
    }

    /** The slopes under which a box is seen, in a direction across the view. */
    Interval slopes(Bounds box, Vector3dc across) {
        return told(ownSlopes(box, across), across);
    }

    /** The slopes under which a primitive is seen: those of its box, narrowed where the primitive is narrower. */
    Interval slopes(Primitive primitive, Bounds box, Vector3dc across) {
        Interval range = ownSlopes(box, across);
        double far = extent(box, forward).most();
        return told(
                new Interval(
                        range.least() + ownGap(primitive, across, range.least(), 1) / far - MARGIN,
                        range.most() - ownGap(primitive, across, range.most(), -1) / far + MARGIN),
                across);
    }

    private Interval told(Interval own, Vector3dc across) {
        double shift = offset.dot(across);
        // the fraction of the distance of the plane that is left
        double zoom = 1 - offset.dot(forward);
        return new Interval(own.least() * zoom + shift, own.most() * zoom + shift);
    }

    private Interval ownSlopes(Bounds box, Vector3dc across) {
        Interval ahead = extent(box, forward);
        Interval sideways = extent(box, across);
        return new Interval(
                sideways.least() / (sideways.least() < 0 ? ahead.least() : ahead.most()) - MARGIN,
                sideways.most() / (sideways.most() > 0 ? ahead.least() : ahead.most()) + MARGIN);
    }

    /** From where to where a box reaches in a direction, seen from the lamp. */
    private Interval extent(Bounds box, Vector3dc direction) {
        double centre = box.centre().sub(place).dot(direction);
        double half = 0.5
                * ((box.maxX() - box.minX()) * Math.abs(direction.x())
                        + (box.maxY() - box.minY()) * Math.abs(direction.y())
                        + (box.maxZ() - box.minZ()) * Math.abs(direction.z()));
        return new Interval(centre - half, centre + half);
    }

    /** How far all of a primitive stands above the plane of a slope (sign 1) or below it (sign -1); else 0. */
    private double ownGap(Primitive primitive, Vector3dc across, double slope, int sign) {
        double nx = sign * (across.x() - slope * forward.x());
        double ny = sign * (across.y() - slope * forward.y());
        double nz = sign * (across.z() - slope * forward.z());
        return Math.max(
                0, primitive.conservativeMinimumAlong(nx, ny, nz) - (nx * place.x() + ny * place.y() + nz * place.z()));
    }
}
