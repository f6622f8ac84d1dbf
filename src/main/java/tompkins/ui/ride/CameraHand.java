package tompkins.ui.ride;

import java.util.function.DoubleConsumer;
import tompkins.camera.Aim.PicturePosition;
import tompkins.camera.Camera;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.FrontWindow;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.PhotographView;

/** Holds the camera of the model: a gesture is a step of the history, unless it is part of a ride. */
final class CameraHand {

    private final StudioModel model;
    private final PhotographView view;
    private final RidePilot pilot;
    private final Object gesture = new Object();

    CameraHand(StudioModel model, PhotographView view, RidePilot pilot) {
        this.model = model;
        this.view = view;
        this.pilot = pilot;
    }

    /** The camera as it is now. */
    Camera camera() {
        return model.studio().camera();
    }

    /** Holds the camera elsewhere from now on. */
    void hold(Camera camera) {
        Object of = pilot.isRiding() ? pilot.gesture() : gesture;
        try {
            model.look(FrontWindow.held(model.studio(), camera), of);
        } catch (InvalidPropertyException tooFar) {
            view.fail(tooFar);
        }
    }

    /** Whether the camera may be moved on board, and not only turned. */
    boolean canMove() {
        return !pilot.isRiding();
    }

    /** The gesture is over. */
    void letGo() {
        model.endGesture(gesture);
    }

    /** Asks how far away what is seen at a place of the picture is. The answer may come later, or never. */
    void askDistance(PicturePosition place, DoubleConsumer answer) {
        view.askDistance(place, answer);
    }
}
