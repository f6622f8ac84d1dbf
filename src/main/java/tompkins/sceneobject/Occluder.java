package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A primitive as a lamp sees it. A long one is seen as a narrow band of directions, which tells most shadow rays that
 * pass it with a single product. Starts of shadow rays that are 1e10 times as far away as the primitive may miss it by
 * rounding.
 */
final class Occluder {

    /** Widening of the band against rounding of directions. */
    private static final double MARGIN = 1e-9;

    /**
     * Least sine of the angle under which the lamp sees the axis, for the plane through both to be known well enough.
     */
    private static final double LEAST_SINE = 1e-3;

    /** Where no band is known the primitive is near every direction. */
    private static final Vector3dc NO_BAND = new Vector3d();

    private final Primitive primitive;
    private final double normalX;
    private final double normalY;
    private final double normalZ;
    private final double reach;

    Occluder(Primitive primitive, Vector3dc lamp) {
        this.primitive = primitive;
        Vector3dc normal = acrossBand(primitive, lamp);
        normalX = normal.x();
        normalY = normal.y();
        normalZ = normal.z();
        reach = normal == NO_BAND ? 1 : halfWidth(primitive, lamp, normal);
    }

    /** The unit normal of the plane through the lamp and the axis of the primitive. */
    private static Vector3dc acrossBand(Primitive primitive, Vector3dc lamp) {
        Vector3d axis = primitive.longAxis();
        if (axis == null || !(primitive.bounds().distance(lamp) > 0)) {
            return NO_BAND;
        }
        Vector3d toCentre = primitive.bounds().centre().sub(lamp);
        Vector3d normal = toCentre.cross(axis, new Vector3d());
        boolean known = normal.length() > LEAST_SINE * axis.length() * toCentre.length();
        return known ? normal.normalize() : NO_BAND;
    }

    /**
     * The largest sine of the angle between that plane and a direction from the lamp to the primitive, or something
     * more.
     */
    private static double halfWidth(Primitive primitive, Vector3dc lamp, Vector3dc normal) {
        double least = primitive.least(normal.x(), normal.y(), normal.z()) - normal.dot(lamp);
        double most = -primitive.least(-normal.x(), -normal.y(), -normal.z()) - normal.dot(lamp);
        double rounding = Primitive.SLACK * (primitive.bounds().farthest() + lamp.length());
        return (Math.max(Math.abs(least), Math.abs(most)) + rounding)
                        / primitive.bounds().distance(lamp)
                + MARGIN;
    }

    Primitive primitive() {
        return primitive;
    }

    /** Whether the primitive may lie on a line through the lamp with the given unit direction. */
    boolean isNear(double dx, double dy, double dz) {
        return Math.abs(dx * normalX + dy * normalY + dz * normalZ) <= reach;
    }
}
