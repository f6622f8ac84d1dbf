package tompkins.ui;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
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
        LensRay axis = camera.centralRay(focusPoint(camera));
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        double before = camera.shutter().transmissionTime(axis, sceneFromCamera);
        double opening = shutter.openingTime() + before - shutter.transmissionTime(axis, sceneFromCamera);
        Shutter opened = Double.isFinite(opening) ? shutter.openedAt(NumberText.rounded(opening, 9)) : shutter;
        return studio.withCamera(camera.withShutter(opened));
    }

    private static Vector3dc focusPoint(Camera camera) {
        double distance = camera.focusDistance();
        return new Vector3d(camera.viewDirection())
                .normalize()
                .mul(distance > 0 && Double.isFinite(distance) ? distance : 1)
                .add(camera.position());
    }
}
