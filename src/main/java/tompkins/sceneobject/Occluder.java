package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A primitive as a lamp sees it. A long one is seen as a narrow band of directions, which tells most shadow rays that pass it
 * with a single product. Starts of shadow rays that are 1e10 times as far away as the primitive may miss it by rounding.
 */
final class Occluder {

    /** Widening of the band against rounding: of directions, and relative to the coordinates. */
    private static final double MARGIN = 1e-9;

    private static final double SLACK = 1e-12;

    /** Least sine of the angle under which the lamp sees the axis, for the plane through both to be known well enough. */
    private static final double LEAST_SINE = 1e-3;

    private final Primitive primitive;
    private final double normalX;
    private final double normalY;
    private final double normalZ;
    private final double reach;

    Occluder(Primitive primitive, Vector3dc lamp) {
        this.primitive = primitive;
        Vector3d axis = primitive.longAxis();
        Bounds bounds = primitive.bounds();
        Vector3d toLamp =
                new Vector3d(lamp).sub(bounds.twiceCentre(0) / 2, bounds.twiceCentre(1) / 2, bounds.twiceCentre(2) / 2);
        Vector3d normal = axis == null ? new Vector3d() : axis.cross(toLamp, new Vector3d());
        double distance = bounds.distance(lamp);
        if (axis == null || !(normal.length() > LEAST_SINE * axis.length() * toLamp.length()) || !(distance > 0)) {
            normalX = 0;
            normalY = 0;
            normalZ = 0;
            reach = 1;
            return;
        }
        normal.normalize();
        normalX = normal.x;
        normalY = normal.y;
        normalZ = normal.z;
        double least = primitive.least(normalX, normalY, normalZ) - normal.dot(lamp);
        double most = -primitive.least(-normalX, -normalY, -normalZ) - normal.dot(lamp);
        double rounding = SLACK * (bounds.farthest() + lamp.length());
        reach = (Math.max(Math.abs(least), Math.abs(most)) + rounding) / distance + MARGIN;
    }

    Primitive primitive() {
        return primitive;
    }

    /** Whether the primitive may lie on a line through the lamp with the given unit direction. */
    boolean isNear(double dx, double dy, double dz) {
        return Math.abs(dx * normalX + dy * normalY + dz * normalZ) <= reach;
    }
}
