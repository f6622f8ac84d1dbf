package tompkins.surface;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.Hit;
import tompkins.ray.SurfaceCoordinates;

/** The axes in which the velocity of a window is given. */
public enum WindowAxes {
    /** The axes of the frame in which the window stands. */
    FRAME,
    /** The window's own axes: its first and second surface coordinate and its normal. */
    SURFACE;

    /** A vector given in these axes, in the axes of the frame. */
    Vector3dc inFrame(Vector3dc vector, Hit hit) {
        return this == FRAME ? vector : ofSurface(hit).transform(vector, new Vector3d());
    }

    /** The unit vectors along the axes of the surface at a hit, as columns: the matrix takes them to the frame. */
    static Matrix3d ofSurface(Hit hit) {
        SurfaceCoordinates at = hit.coordinates;
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        // gradients may leave the surface, as that of the height does on a cone: only their part in the surface counts
        Vector3d first = unit(without(normal, new Vector3d(at.uX(), at.uY(), at.uZ())), Vectors.firstAxis(normal));
        // the second axis is the part of its coordinate's gradient that the first does not hold
        Vector3d second = unit(
                without(first, without(normal, new Vector3d(at.vX(), at.vY(), at.vZ()))),
                first.cross(normal, new Vector3d()));
        return new Matrix3d(first, second, normal);
    }

    /** The unit vector along a vector, or the other one if rounding leaves nothing of it. */
    private static Vector3d unit(Vector3d vector, Vector3dc other) {
        return vector.lengthSquared() > 0 ? Vectors.unit(vector) : new Vector3d(other);
    }

    /** A vector without its part along a unit vector. */
    private static Vector3d without(Vector3dc unit, Vector3d vector) {
        double along = vector.dot(unit);
        return vector.sub(unit.x() * along, unit.y() * along, unit.z() * along);
    }
}
