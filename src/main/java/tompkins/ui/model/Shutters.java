package tompkins.ui.model;

import tompkins.camera.Camera;
import tompkins.property.Descriptions;
import tompkins.property.NumberText;
import tompkins.shutter.Shutter;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;

/** Replaces one shutter model by another. */
public final class Shutters {

    private Shutters() {}

    /**
     * The studio with another shutter model, opened so that the light in the middle of the picture crosses the lens
     * when it did before: only the model changes the picture.
     */
    public static Studio replaced(Studio studio, Class<?> model) {
        Camera camera = studio.camera();
        Shutter shutter = (Shutter) Descriptions.standard(model);
        double opening = shutter.openingTime()
                + LensEvent.timeInMiddle(camera, studio.sceneFromCamera())
                - LensEvent.timeInMiddle(camera.withShutter(shutter), studio.sceneFromCamera());
        Shutter opened = Double.isFinite(opening) ? shutter.openedAt(NumberText.rounded(opening, 9)) : shutter;
        return studio.withCamera(camera.withShutter(opened));
    }
}
