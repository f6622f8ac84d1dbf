package tompkins.camera;

import org.joml.Vector3dc;
import tompkins.property.Descriptions;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A camera, described in its rest frame. Immutable, checked when it is made. {@link CameraMotion}, {@link Aim},
 * {@link FieldOfView} and {@link FocusDistance} make changed cameras from it.
 */
public sealed interface Camera permits ThinLensCamera, PanoramicCamera {

    /** Where the shutter is and when it opens. */
    Shutter shutter();

    /** Whether the camera can have a shutter of some type. */
    default boolean accepts(Class<?> shutter) {
        return true;
    }

    /** The same camera with another shutter. */
    default Camera withShutter(Shutter shutter) {
        return Descriptions.with(this, "shutter", shutter);
    }

    /**
     * For how long the shutter stays open; 0 for an instant. Light crosses the lens for this long from the time that
     * the shutter model gives, and the picture is the mean over it.
     */
    double exposureTime();

    /** How much later than the shutter model says each line of the picture opens. */
    RollingShutter rollingShutter();

    /** The pictures of two eyes, or one picture. */
    Stereo stereo();

    /** The same camera with other eyes. */
    default Camera withStereo(Stereo stereo) {
        return Descriptions.with(this, "stereo", stereo);
    }

    /** The camera that takes one picture from between the eyes. */
    default Camera betweenEyes() {
        return stereo().layout() == StereoLayout.NONE ? this : withStereo(Stereo.DEFAULT);
    }

    /** Centre of the lens; with two eyes the middle between their lenses. */
    Vector3dc position();

    /** Direction of the middle of the picture, of any length. */
    Vector3dc viewDirection();

    /** Direction that points up in the picture, of any length, as far as the view direction allows. */
    Vector3dc topDirection();

    /** Direction that points to the right in the middle of the picture; a unit vector. */
    default Vector3dc rightDirection() {
        return CameraAxes.of(viewDirection(), topDirection()).right();
    }

    /** Direction that points up in the picture, in its middle; a unit vector. */
    default Vector3dc upDirection() {
        return CameraAxes.of(viewDirection(), topDirection()).up();
    }

    /** Angle between the left and the right edge of the picture, in degrees. */
    double horizontalAngleDegrees();

    /** Exposure compensation in stops: the light is multiplied by 2 to this power. */
    double exposureStops();

    /** Whether different points of the lens take different pictures. */
    boolean hasWideAperture();

    /**
     * The camera, ready to take the picture of one eye; of a camera with both eyes the one from between them. All
     * pictures of a camera are in {@link PictureRays}.
     *
     * @param width pixels in a row
     * @param height number of rows
     * @param sceneFromCamera the change of frame, for the shutter
     */
    CameraRays rays(int width, int height, SpaceTimeTransformation sceneFromCamera);
}
