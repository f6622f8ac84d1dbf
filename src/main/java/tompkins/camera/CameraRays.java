package tompkins.camera;

import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayBlock;
import tompkins.ray.RayCounts;

/** A camera that is ready to take one picture. Immutable, shared by all threads. */
public interface CameraRays {

    /**
     * The ray that belongs to a point of the picture and a point of the lens, in the camera frame.
     *
     * @param x place in the picture in pixels, from 0 at the left edge; pixel centres lie at halves
     * @param y place in the picture in pixels, from 0 at the upper edge
     * @param lensX place on the lens in units of its radius, to the right; a point of the unit disc
     * @param lensY place on the lens in units of its radius, up
     * @param counts takes note of rays without focus or shutter
     * @return the ray, or null if it brings no light because it never crosses the shutter
     */
    default Ray ray(double x, double y, double lensX, double lensY, RayCounts counts) {
        RayBlock one = new RayBlock(1);
        return add(x, y, lensX, lensY, one, counts) ? one.ray(0) : null;
    }

    /** Adds that ray to a block; false if there is none. */
    boolean add(double x, double y, double lensX, double lensY, RayBlock rays, RayCounts counts);

    /** The unit direction of the ray through the centre of the lens for a point of the picture in pixels. */
    Vector3dc chiefDirection(double x, double y);
}
