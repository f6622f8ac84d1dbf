package tompkins.camera;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The law of the ideal thin lens, in slopes: it stays finite for objects in the focal plane and at infinity. */
public final class ThinLens {

    private ThinLens() {}

    /**
     * The direction of a ray behind an ideal thin lens: {@code d/|d.a| - r/f}, not of unit length.
     *
     * @param direction direction of the ray before the lens
     * @param axis unit vector along the axis of the lens
     * @param offset from the centre of the lens to the point where the ray meets it; its part along the axis does not count
     * @param power 1/f, in inverse lengths
     */
    public static Vector3d bend(Vector3dc direction, Vector3dc axis, Vector3dc offset, double power) {
        double along = offset.dot(axis);
        Vector3d across = new Vector3d(
                offset.x() - along * axis.x(), offset.y() - along * axis.y(), offset.z() - along * axis.z());
        return new Vector3d(direction).div(Math.abs(direction.dot(axis))).sub(across.mul(power));
    }
}
