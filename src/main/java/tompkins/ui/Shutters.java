package tompkins.ui;

import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.shutter.LensRay;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.Studio;

/** Puts one shutter model in the place of another. */
final class Shutters {

    private Shutters() {}

    /**
     * The studio with another shutter model, opened so that the light in the middle of the picture crosses the lens when it
     * did before: what changes in the picture is the model's doing alone.
     */
    static Studio replaced(Studio studio, Class<?> model) {
        Camera camera = studio.camera();
        Shutter shutter = (Shutter) Descriptions.standard(model);
        LensRay axis = axis(camera);
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        double before = camera.shutter().transmissionTime(axis, sceneFromCamera);
        double opening = shutter.openingTime() + before - shutter.transmissionTime(axis, sceneFromCamera);
        Shutter opened = Double.isFinite(opening) ? shutter.openedAt(NumberText.rounded(opening, 9)) : shutter;
        return studio.withCamera(camera.withShutter(opened));
    }

    /** The ray in the middle of the picture, focused where the camera is; at infinity if nothing is in focus. */
    private static LensRay axis(Camera camera) {
        Vector3dc view = Vectors.unit(camera.viewDirection());
        double distance = camera.focusDistance();
        double inverseDistance = Double.isNaN(distance) ? 0 : 1 / distance;
        return new LensRay(camera.position(), camera.position(), view, inverseDistance, view);
    }
}
