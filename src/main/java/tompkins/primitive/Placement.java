package tompkins.primitive;

import org.joml.Matrix3d;
import org.joml.Matrix3dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** How an object is placed: {@code x' = scale R x + translation}, with a rotation R. */
public final class Placement {

    /** Leaves an object as it is described: scale 1, no rotation, no translation. */
    public static final Placement NONE = new Placement(1, new Matrix3d(), new Vector3d());

    private final double scale;
    private final Matrix3dc rotation;
    private final Vector3dc translation;

    /** A placement by scale (above 0), rotation and translation, in this order. */
    public Placement(double scale, Matrix3dc rotation, Vector3dc translation) {
        this.scale = scale;
        this.rotation = new Matrix3d(rotation);
        this.translation = new Vector3d(translation);
    }

    /** The placement that first applies {@code inner}, then this. */
    public Placement after(Placement inner) {
        return new Placement(
                scale * inner.scale, rotation.mul(inner.rotation, new Matrix3d()), point(inner.translation));
    }

    /** Factor of all lengths. */
    public double scale() {
        return scale;
    }

    /** A point after the placement. */
    public Vector3d point(Vector3dc point) {
        return vector(point).add(translation);
    }

    /** The difference of two points after the placement. */
    public Vector3d vector(Vector3dc vector) {
        return direction(vector).mul(scale);
    }

    /** A direction after the placement: rotated only. */
    public Vector3d direction(Vector3dc direction) {
        // adding 0 turns -0 into 0, so that rotations by nothing keep the bits
        return rotation.transform(direction, new Vector3d()).add(0, 0, 0);
    }
}
