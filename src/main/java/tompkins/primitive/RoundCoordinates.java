package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.SurfaceCoordinates;

/**
 * Coordinates on a sphere or on the mantle of an object around an axis. With the axis upwards and seen from outside, u
 * runs once around, from left to right, and v upwards; u is 1/2 on the side of {@link Vectors#middleAround}, and
 * follows the object when it is placed.
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
        return new SurfaceCoordinates(u, v, alongU, alongV);
    }

    /**
     * The coordinates of a point of a sphere: v from the lowest point (0) to the highest (1), even in angles.
     *
     * @param normal unit vector from the centre to the point
     * @param radius radius of the sphere
     */
    SurfaceCoordinates onSphere(Vector3dc normal, double radius) {
        double toRight = normal.dot(right);
        double toMiddle = normal.dot(middle);
        double height = normal.dot(axis);
        double level = Math.hypot(toRight, toMiddle);
        double u = Math.atan2(toRight, toMiddle) / (2 * Math.PI) + 0.5;
        double v = Math.atan2(height, level) / Math.PI + 0.5;
        double perTurn = 1 / (2 * Math.PI * radius * Math.max(level, 1e-12));
        double perHalfTurn = 1 / (Math.PI * radius);
        Vector3d alongU = level == 0
                ? new Vector3d(right)
                : new Vector3d(right).mul(toMiddle / level).sub(new Vector3d(middle).mul(toRight / level));
        // at a pole all directions are level: the limit from in front is used
        Vector3d alongV = level == 0
                ? new Vector3d(middle).mul(-height)
                : new Vector3d(axis).sub(new Vector3d(normal).mul(height)).div(level);
        return new SurfaceCoordinates(u, v, alongU.mul(perTurn), alongV.mul(perHalfTurn));
    }
}
