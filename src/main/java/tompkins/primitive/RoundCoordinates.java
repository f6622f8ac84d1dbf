package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.SurfaceCoordinates;

/**
 * Coordinates on the mantle of an object around an axis. With the axis upwards and seen from outside, u runs once
 * around, from left to right, and v upwards; u is 1/2 on the side of {@link Vectors#middleAround}, and follows the
 * object when it is placed.
 *
 * @param axis unit vector, upwards
 * @param middle unit vector to the side where u is 1/2
 * @param right unit vector to the side where u is 3/4
 */
record RoundCoordinates(Vector3dc axis, Vector3dc middle, Vector3dc right) {

    /** Those around an axis (of any length) that is described before the placement. */
    static RoundCoordinates around(Vector3dc axis, Placement placement) {
        Vector3d unit = Vectors.unit(axis);
        Vector3d middle = Vectors.middleAround(unit);
        Vector3d right = middle.cross(unit, new Vector3d());
        return new RoundCoordinates(placement.direction(unit), placement.direction(middle), placement.direction(right));
    }

    /**
     * The coordinates of a point.
     *
     * @param outwards unit vector from the axis to the point
     * @param radius distance from the axis, above 0
     * @param v the second coordinate
     * @param length the length along the axis over which v grows by 1
     */
    SurfaceCoordinates at(Vector3dc outwards, double radius, double v, double length) {
        double u = Math.atan2(outwards.dot(right), outwards.dot(middle)) / (2 * Math.PI) + 0.5;
        Vector3d alongU = outwards.cross(axis, new Vector3d()).div(2 * Math.PI * radius);
        Vector3d alongV = axis.div(length, new Vector3d());
        return new SurfaceCoordinates(u, v, alongU.x, alongU.y, alongU.z, alongV.x, alongV.y, alongV.z);
    }
}
