package tompkins.camera;

import org.joml.Quaterniond;
import org.joml.Vector3dc;
import tompkins.math.RigidMotion;
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

    /** Direction that points up in the picture, in its middle; a unit vector. */
    default Vector3dc upDirection() {
        return CameraAxes.of(viewDirection(), topDirection()).up();
    }

    /** The same camera after a motion in its own frame; its focus and its shutter go along. */
    default Camera moved(RigidMotion motion) {
        return moved(
                motion, motion.place(position()), motion.direction(viewDirection()), motion.direction(topDirection()));
    }

    /**
     * The same camera, turned about the centre of its lens; its focus and its shutter turn with it.
     *
     * @throws tompkins.property.InvalidPropertyException if the directions are parallel
     */
    default Camera turned(Vector3dc newView, Vector3dc newTop) {
        CameraAxes.requireTop(newTop, newView);
        CameraAxes before = CameraAxes.of(viewDirection(), topDirection());
        RigidMotion turn =
                RigidMotion.about(position(), CameraAxes.of(newView, newTop).turnFrom(before));
        return moved(turn, position(), newView, newTop);
    }

    /** The motion that takes the lens and the axes of this camera to those of another one. */
    default RigidMotion motionTo(Camera other) {
        CameraAxes before = CameraAxes.of(viewDirection(), topDirection());
        CameraAxes after = CameraAxes.of(other.viewDirection(), other.topDirection());
        return RigidMotion.about(position(), after.turnFrom(before), other.position());
    }

    /** The same camera at another place of its frame; its focus and its shutter go along. */
    default Camera shifted(Vector3dc way) {
        return moved(new RigidMotion(new Quaterniond(), way));
    }

    /** The same camera after a motion that has led to a place and to directions. */
    Camera moved(RigidMotion motion, Vector3dc newPosition, Vector3dc newView, Vector3dc newTop);

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
