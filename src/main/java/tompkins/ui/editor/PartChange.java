package tompkins.ui.editor;

import tompkins.camera.Camera;
import tompkins.camera.FieldOfView;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.model.Shutters;

/** Changes a part of a studio, and what goes along with it. */
final class PartChange {

    private static final StudioPath FIELD_OF_VIEW =
            StudioPath.ROOT.then("camera").then("horizontalAngleDegrees");

    private PartChange() {}

    /**
     * The studio with another part. A window in front of the lens goes on following the camera, another kind of shutter
     * opens so that the middle of the picture keeps its time, and another field of view keeps the shape of pixels.
     *
     * @throws InvalidPropertyException if the studio does not accept the part
     */
    static Studio with(Studio studio, StudioPath path, Object part) {
        if (path.equals(FIELD_OF_VIEW)) {
            return studio.withCamera(FieldOfView.with(studio.camera(), (Double) part));
        }
        Studio changed = FrontWindow.following(studio, path.with(studio, part));
        Camera camera = changed.camera();
        Class<?> shutter = camera.shutter().getClass();
        boolean otherShutter = camera.getClass() == studio.camera().getClass()
                && shutter != studio.camera().shutter().getClass();
        return otherShutter
                ? Shutters.replaced(
                        changed.withCamera(camera.withShutter(studio.camera().shutter())), shutter)
                : changed;
    }
}
