package tompkins.camera;

import org.joml.Vector3dc;
import tompkins.shutter.LensRay;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;

/** A camera, described in its own frame. Immutable, checked when it is made. */
public sealed interface Camera permits ThinLensCamera, PanoramicCamera {

    /** Where the shutter is and when it opens. */
    Shutter shutter();

    /** The same camera with another shutter. */
    Camera withShutter(Shutter shutter);

    /** Centre of the lens. */
    Vector3dc position();

    /** Exposure compensation in stops: the light is multiplied by 2 to this power. */
    double exposureStops();

    /** Whether different points of the lens take different pictures. */
    boolean hasWideLens();

    /** The ray through the centre of the lens that belongs to a point in front of the camera, focused on that point. */
    LensRay centralRay(Vector3dc point);

    /**
     * The camera, ready to take a picture.
     *
     * @param width pixels in a row
     * @param height number of rows
     * @param sceneFromCamera the change of frame, for the shutter
     */
    CameraRays rays(int width, int height, SpaceTimeTransformation sceneFromCamera);
}
