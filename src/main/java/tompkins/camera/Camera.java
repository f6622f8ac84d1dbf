package tompkins.camera;

import org.joml.Vector3dc;
import tompkins.property.Descriptions;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;

/** A camera, described in its own frame. Immutable, checked when it is made. */
public sealed interface Camera permits ThinLensCamera, PanoramicCamera {

    /** Where the shutter is and when it opens. */
    Shutter shutter();

    /** The same camera with another shutter. */
    Camera withShutter(Shutter shutter);

    /**
     * For how long the shutter stays open; 0 for an instant. Light crosses the lens from the time that the shutter
     * model gives until so much later, and the picture is the mean over it.
     */
    double exposureTime();

    /** The same camera with another exposure time. */
    default Camera withExposureTime(double time) {
        return Descriptions.with(this, "exposureTime", time);
    }

    /** How much later than the shutter model says each line of the picture opens. */
    RollingShutter rollingShutter();

    /** The same camera whose shutter runs across the picture in another way. */
    default Camera withRollingShutter(RollingShutter rolling) {
        return Descriptions.with(this, "rollingShutter", rolling);
    }

    /** Centre of the lens. */
    Vector3dc position();

    /** Direction of the middle of the picture, of any length. */
    Vector3dc viewDirection();

    /** Direction that points up in the picture, of any length, as far as the view direction allows. */
    Vector3dc topDirection();

    /** Direction that points to the right in the middle of the picture; a unit vector. */
    default Vector3dc rightDirection() {
        return CameraAxes.of(viewDirection(), topDirection()).right();
    }

    /**
     * The distance of what is in focus in the middle of the picture: above 0 in front of the camera, below 0 behind it,
     * not finite if nothing is.
     */
    double focusDistance();

    /** The distance at which the camera has to be focused for a point to be sharp; below 0 for one behind it. */
    double focusDistanceOf(Vector3dc point);

    /** Angle between the left and the right edge of the picture, in degrees. */
    double horizontalAngleDegrees();

    /**
     * The same camera with another angle between the left and the right edge of the picture. The other angle changes
     * with it, so that pixels keep their shape, as far as possible.
     *
     * @throws tompkins.property.InvalidPropertyException if no picture is so wide
     */
    Camera withHorizontalAngle(double degrees);

    /**
     * The same camera, focused at a distance.
     *
     * @throws tompkins.property.InvalidPropertyException if it cannot be focused there
     */
    Camera focusedAt(double distance);

    /** Exposure compensation in stops: the light is multiplied by 2 to this power. */
    double exposureStops();

    /** Whether different points of the lens take different pictures. */
    boolean hasWideAperture();

    /**
     * The camera, ready to take a picture.
     *
     * @param width pixels in a row
     * @param height number of rows
     * @param sceneFromCamera the change of frame, for the shutter
     */
    CameraRays rays(int width, int height, SpaceTimeTransformation sceneFromCamera);
}
