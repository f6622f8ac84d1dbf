package tompkins.surface;

import org.joml.Vector3d;
import org.joml.Vector3dc;
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
        if (this == FRAME) {
            return vector;
        }
        SurfaceCoordinates at = hit.coordinates;
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        Vector3d first = new Vector3d(at.uX(), at.uY(), at.uZ()).normalize();
        Vector3d second = new Vector3d(at.vX(), at.vY(), at.vZ());
        // the second axis is the part of its coordinate's gradient that the first does not hold
        second.sub(new Vector3d(first).mul(second.dot(first))).normalize();
        return first.mul(vector.x()).add(second.mul(vector.y())).add(normal.mul(vector.z()));
    }
}
