package tompkins.primitive;

import org.joml.Matrix3d;
import org.joml.Matrix3dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;

/**
 * How an object is placed: {@code x' = scale R x + translation - origin}, with a rotation R. The origin is where the
 * tracer's coordinates of the frame begin: (0, 0, 0), unless the camera is far from there.
 */
public final class Placement {

    /** Leaves an object as it is described: scale 1, no rotation, no translation. */
    public static final Placement NONE = new Placement(1, new Matrix3d(), new Vector3d());

    private final double scale;
    private final Matrix3dc rotation;
    private final Vector3dc translation;
    private final Vector3dc origin;

    /** Translation minus origin, subtracted first so that what is near the origin keeps its digits. */
    private final Vector3dc shift;

    /** A placement by scale (above 0), rotation and translation, in this order. */
    public Placement(double scale, Matrix3dc rotation, Vector3dc translation) {
        this(scale, rotation, translation, new Vector3d());
    }

    /** As above, in coordinates that begin at an origin. */
    public Placement(double scale, Matrix3dc rotation, Vector3dc translation, Vector3dc origin) {
        this.scale = scale;
        this.rotation = new Matrix3d(rotation);
        this.translation = new Vector3d(translation);
        this.origin = new Vector3d(origin);
        shift = translation.sub(origin, new Vector3d());
    }

    /** The placement that first applies {@code inner}, then this. */
    public Placement after(Placement inner) {
        return new Placement(
                scale * inner.scale, rotation.mul(inner.rotation, new Matrix3d()), place(inner.translation), origin);
    }

    /** Factor of all lengths. */
    public double scale() {
        return scale;
    }

    /** A point after the placement. */
    public Vector3d point(Vector3dc point) {
        return vector(point).add(shift);
    }

    /** A point after the placement, in the coordinates of its frame, wherever those of the tracer begin. */
    public Vector3d place(Vector3dc point) {
        return vector(point).add(translation);
    }

    /** The same scale and rotation in another frame. */
    public Placement inFrame(Vector3dc newTranslation, Vector3dc newOrigin) {
        return new Placement(scale, rotation, newTranslation, newOrigin);
    }

    /** A velocity after the placement: rotated only. */
    public Velocity velocity(Velocity velocity) {
        Vector3d turned = direction(velocity.given());
        return velocity.isRest() || turned.equals(velocity.given())
                ? velocity
                : velocity.along(turned, SpeedScale.GAMMA);
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
