package tompkins.measure;

import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.math.Vectors;

/**
 * The plane across the view direction at the distance 1 from the lens, on which a lens draws its picture: what lies
 * there at (x, y) is seen in the direction ahead + x right + y up.
 */
record PicturePlane(Vector3dc right, Vector3dc up, Vector3dc ahead) {

    static PicturePlane of(Camera camera) {
        return new PicturePlane(camera.rightDirection(), camera.upDirection(), Vectors.unit(camera.viewDirection()));
    }

    /** The place of a direction; null if it does not lie ahead. */
    Vector2d place(Vector3dc direction) {
        double depth = direction.dot(ahead);
        return depth > 0 ? new Vector2d(direction.dot(right), direction.dot(up)).div(depth) : null;
    }

    /** The unit direction of a place. */
    Vector3d direction(Vector2dc place) {
        return new Vector3d(ahead).fma(place.x(), right).fma(place.y(), up).normalize();
    }
}
