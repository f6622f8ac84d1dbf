package tompkins.camera;

import org.joml.Vector3dc;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;

/** Cameras with one eye, whose shutters open for an instant, all of them at once. */
public final class Cameras {

    private Cameras() {}

    /** A camera with a lens. */
    public static ThinLensCamera lens(
            Vector3dc position,
            Vector3dc viewDirection,
            Vector3dc topDirection,
            double horizontalAngleDegrees,
            double verticalAngleDegrees,
            double apertureRadius,
            SceneObject focus,
            double exposureStops,
            Shutter shutter) {
        return new ThinLensCamera(
                position,
                viewDirection,
                topDirection,
                horizontalAngleDegrees,
                verticalAngleDegrees,
                apertureRadius,
                0,
                focus,
                exposureStops,
                shutter,
                0,
                RollingShutter.DEFAULT,
                Stereo.DEFAULT);
    }

    /** A camera for panoramas. */
    public static PanoramicCamera panorama(
            Vector3dc position,
            Vector3dc viewDirection,
            Vector3dc topDirection,
            double horizontalAngleDegrees,
            double verticalAngleDegrees,
            double focusDistance,
            double exposureStops,
            Shutter shutter) {
        return new PanoramicCamera(
                position,
                viewDirection,
                topDirection,
                horizontalAngleDegrees,
                verticalAngleDegrees,
                focusDistance,
                exposureStops,
                shutter,
                0,
                RollingShutter.DEFAULT,
                Stereo.DEFAULT);
    }
}
