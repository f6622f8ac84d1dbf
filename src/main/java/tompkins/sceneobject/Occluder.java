package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A primitive as a lamp sees it: a long one as a narrow band of directions, another as a circle of them, which tells
 * most shadow rays that pass it with a few products. Starts of shadow rays that are 1e9 times as far away as the
 * primitive may miss it by rounding.
 */
final class Occluder {

    /** Widening of the band or circle against rounding of directions. */
    private static final double MARGIN = 1e-7;

    /**
     * Least sine of the angle under which the lamp sees the axis, for the plane through both to be known well enough.
     */
    private static final double LEAST_SINE = 1e-3;

    private final Primitive primitive;
    private final float leastDistance;

    /** Whether (x, y, z) is the normal of a band, not the middle of a circle. */
    private final boolean band;

    private final double x;
    private final double y;
    private final double z;
    private final double reach;

    Occluder(Primitive primitive, Vector3dc lamp) {
        this.primitive = primitive;
        Bounds bounds = primitive.bounds();
        double rounding = Primitive.SLACK * (bounds.farthest() + lamp.length());
        double distance = bounds.distance(lamp);
        leastDistance = Math.max(0, Math.nextDown((float) (distance - rounding)));
        Vector3d toCentre = bounds.centre().sub(lamp);
        Vector3d normal = distance > 0 ? acrossBand(primitive, toCentre) : null;
        band = normal != null;
        if (band) {
            reach = (halfWidth(primitive, lamp, normal) + rounding) / distance + MARGIN;
        } else {
            double sine = (primitive.boundingRadius() + rounding) / toCentre.length() + MARGIN;
            // from inside it is near every direction
            normal = sine < 1 ? toCentre.normalize() : new Vector3d();
            reach = sine * sine;
        }
        x = normal.x;
        y = normal.y;
        z = normal.z;
    }

    /** The unit normal of the plane through the lamp and the axis of the primitive; null if that is not known. */
    private static Vector3d acrossBand(Primitive primitive, Vector3dc toCentre) {
        Vector3d axis = primitive.longAxis();
        if (axis == null) {
            return null;
        }
        Vector3d normal = toCentre.cross(axis, new Vector3d());
        boolean known = normal.length() > LEAST_SINE * axis.length() * toCentre.length();
        return known ? normal.normalize() : null;
    }

    /** The largest distance of a point of the primitive from that plane. */
    private static double halfWidth(Primitive primitive, Vector3dc lamp, Vector3dc normal) {
        double least = primitive.least(normal.x(), normal.y(), normal.z()) - normal.dot(lamp);
        double most = -primitive.least(-normal.x(), -normal.y(), -normal.z()) - normal.dot(lamp);
        return Math.max(Math.abs(least), Math.abs(most));
    }

    Primitive primitive() {
        return primitive;
    }

    /** A distance from the lamp that no point of the primitive falls below; 0 or more. */
    float leastDistance() {
        return leastDistance;
    }

    /** Whether the primitive may lie on a line through the lamp with the given unit direction. */
    boolean isNear(double dx, double dy, double dz) {
        if (band) {
            return Math.abs(dx * x + dy * y + dz * z) <= reach;
        }
        double crossX = dy * z - dz * y;
        double crossY = dz * x - dx * z;
        double crossZ = dx * y - dy * x;
        return crossX * crossX + crossY * crossY + crossZ * crossZ <= reach;
    }
}
