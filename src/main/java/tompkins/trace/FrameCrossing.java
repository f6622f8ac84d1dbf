package tompkins.trace;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * The way of a ray from the camera frame into the scene frame.
 *
 * <p>A camera that has been on its way for a long time is far from the origin of the scene frame, and so is everything
 * that it sees: with coordinates of order 1e7 a double has no digits left for rods of radius 0.02. Then the scene is
 * described from an origin of its own near the camera (a vector of doubles, subtracted exactly from the objects), rays
 * are transformed relative to the lens, and the rest between the lens and that origin is added, worked out once with
 * sixty digits.
 */
final class FrameCrossing {

    /** Distance of the camera from the origin at which the scene gets an origin of its own. */
    private static final double FAR = 1000;

    private final SpaceTimeTransformation sceneFromCamera;
    private final Vector3dc origin;

    /** In the camera frame; null if the scene keeps its own origin. */
    private final Event lens;

    // of the lens in the scene frame
    private final Vector3dc lensFromOrigin;
    private final double lensTime;

    /**
     * The crossing for rays that start near an event.
     *
     * @param lens an event at the lens, in the camera frame
     */
    FrameCrossing(SpaceTimeTransformation sceneFromCamera, Event lens) {
        this.sceneFromCamera = sceneFromCamera;
        Event inScene = sceneFromCamera.transform(lens);
        Vector3d place = inScene.position();
        // a camera at rest has not flown far from what it sees
        boolean atRest = sceneFromCamera instanceof IdentityTransformation;
        if (atRest || !place.isFinite() || place.length() < FAR) {
            origin = new Vector3d();
            this.lens = null;
            lensFromOrigin = new Vector3d();
            lensTime = 0;
            return;
        }
        origin = place;
        this.lens = lens;
        lensFromOrigin = sceneFromCamera.placeFrom(place, lens);
        lensTime = inScene.time();
    }

    /** The ray in the scene frame, in coordinates relative to {@link #origin()}. */
    Ray cross(Ray ray) {
        if (lens == null) {
            return sceneFromCamera.transform(ray);
        }
        Ray fromLens = ray.moved(-lens.x(), -lens.y(), -lens.z(), -lens.time());
        return sceneFromCamera
                .transform(fromLens)
                .moved(lensFromOrigin.x(), lensFromOrigin.y(), lensFromOrigin.z(), lensTime);
    }

    /** Takes each ray of a block into the scene frame, as {@link #cross(Ray)}. */
    void cross(RayPacket rays) {
        if (lens == null) {
            sceneFromCamera.transform(rays);
            return;
        }
        shift(rays, -lens.x(), -lens.y(), -lens.z(), -lens.time());
        sceneFromCamera.transform(rays);
        shift(rays, lensFromOrigin.x(), lensFromOrigin.y(), lensFromOrigin.z(), lensTime);
    }

    private static void shift(RayPacket rays, double x, double y, double z, double time) {
        for (int i = 0; i < rays.count(); i++) {
            rays.x[i] += x;
            rays.y[i] += y;
            rays.z[i] += z;
            rays.time[i] += time;
        }
    }

    /** The place in the scene frame from which its objects are described to the tracer; usually (0, 0, 0). */
    Vector3dc origin() {
        return origin;
    }
}
