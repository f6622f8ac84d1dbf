package tompkins.primitive;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.ray.SurfaceCoordinates;

/**
 * Coordinates on a flat face of an object: seen from outside, u runs from 0 at the left edge to 1 at the right one, and
 * v from 0 at the lower edge to 1 at the upper one, where {@link Vectors#upOnFace} says what is up before the object is
 * placed.
 *
 * @param alongU the change of place over which u grows by 1, divided by the square of its length
 * @param alongV the same for v
 */
record FaceCoordinates(Vector3dc alongU, Vector3dc alongV) {

    /**
     * Those of a face that is described before the placement.
     *
     * @param outwards unit vector out of the face, before the placement
     * @param width length of the face from left to right, before the placement
     * @param height length of the face from bottom to top, before the placement
     */
    static FaceCoordinates across(Vector3dc outwards, double width, double height, Placement placement) {
        Vector3d up = Vectors.upOnFace(outwards);
        Vector3d right = outwards.cross(up, new Vector3d());
        return new FaceCoordinates(
                placement.direction(right).div(width * placement.scale()),
                placement.direction(up).div(height * placement.scale()));
    }

    /** The coordinates of a point, seen from the middle of the face or from straight behind it. */
    SurfaceCoordinates at(double x, double y, double z) {
        return new SurfaceCoordinates(
                alongU.x() * x + alongU.y() * y + alongU.z() * z + 0.5,
                alongV.x() * x + alongV.y() * y + alongV.z() * z + 0.5,
                alongU,
                alongV);
    }
}
