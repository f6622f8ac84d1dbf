package tompkins.sceneobject;

import org.joml.Vector3dc;
import tompkins.spacetime.Event;

/** Where and when the camera photographs points that are fixed to it. */
@FunctionalInterface
public interface ImagePoints {

    /**
     * The event, in the scene frame, at which a point that is fixed to the camera is photographed by the ray through
     * the centre of the lens.
     *
     * @param cameraPoint the point, in the camera frame
     */
    Event inScene(Vector3dc cameraPoint);
}
