package tompkins.camera;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.sceneobject.SceneObject;

/** Reads and sets the focus of a camera as one number: the distance that is sharp in the middle of the picture. */
public final class FocusDistance {

    private FocusDistance() {}

    /** The distance in focus: above 0 in front of the camera, below 0 behind it, not finite if there is none. */
    public static double of(Camera camera) {
        if (camera instanceof ThinLensCamera lens) {
            // a plane along the view gives a negative zero
            return 1 / (new FocusSurface(lens.surfaceInFocus()).inverseDistance(lens.position(), view(lens)) + 0.0);
        }
        return ((PanoramicCamera) camera).focusDistance();
    }

    /** The distance at which a camera has to be focused for a point to be sharp; below 0 for one behind a lens. */
    public static double toPoint(Camera camera, Vector3dc point) {
        return camera instanceof ThinLensCamera lens
                ? view(lens).dot(point.sub(lens.position(), new Vector3d()))
                : camera.position().distance(point);
    }

    /**
     * A camera that is focused at a distance: a thin lens on the plane across its view, which may lie behind it.
     *
     * @throws InvalidPropertyException if it cannot be focused there
     */
    public static Camera with(Camera camera, double distance) {
        if (camera instanceof ThinLensCamera lens) {
            if (!(distance != 0 && Double.isFinite(distance))) {
                throw new InvalidPropertyException("focusDistance", "a finite number, not 0", distance);
            }
            double ahead = Math.max(distance, 0);
            SceneObject focus = distance > 0 ? ThinLensCamera.DEFAULT.focus() : lens.planeAcross(distance);
            return Descriptions.changed(
                    lens,
                    (name, before) -> name.equals("focusDistance") ? ahead : name.equals("focus") ? focus : before);
        }
        return Descriptions.with(camera, "focusDistance", distance);
    }

    private static Vector3d view(Camera camera) {
        return Vectors.unit(camera.viewDirection());
    }
}
