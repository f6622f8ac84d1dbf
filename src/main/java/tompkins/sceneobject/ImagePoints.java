package tompkins.sceneobject;

import org.joml.Vector3dc;

/** Where the camera photographs points that are fixed to it. */
@FunctionalInterface
public interface ImagePoints {

    /**
     * The place, in the frame of the objects, of the event at which a point that is fixed to the camera is photographed
     * by the ray through the centre of the lens.
     *
     * @param cameraPoint the point, in the camera frame
     */
    Vector3dc inFrame(Vector3dc cameraPoint);
}
