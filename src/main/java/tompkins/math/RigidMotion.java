package tompkins.math;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A rotation about the origin, and then a move: {@code x' = R x + t}. Immutable.
 *
 * @param rotation unit quaternion of the rotation R, by components: about z, 90 degrees take x to y
 * @param translation the move t
 */
public record RigidMotion(Quaterniondc rotation, Vector3dc translation) {

    /** Keeps copies, which nobody else can change. */
    public RigidMotion {
        rotation = new Quaterniond(rotation);
        translation = new Vector3d(translation);
    }

    /** The motion that turns about a point and takes it to another place. */
    public static RigidMotion about(Vector3dc point, Quaterniondc rotation, Vector3dc place) {
        return new RigidMotion(rotation, place.sub(rotation.transform(point, new Vector3d()), new Vector3d()));
    }

    /** Where the motion takes a point. */
    public Vector3d place(Vector3dc point) {
        return rotation.transform(point, new Vector3d()).add(translation);
    }

    /** A direction after the motion; its length stays. */
    public Vector3d direction(Vector3dc direction) {
        return rotation.transform(direction, new Vector3d());
    }
}
