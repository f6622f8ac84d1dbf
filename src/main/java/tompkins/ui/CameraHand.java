package tompkins.ui;

import java.util.function.DoubleConsumer;
import tompkins.camera.Aim.PicturePlace;
import tompkins.camera.Camera;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.FrontWindow;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.RidePilot;
import tompkins.ui.picture.Steering;

/** Holds the camera of the model: a gesture is a step of the history, unless it is part of a ride. */
final class CameraHand implements Steering.Hand {

    private final StudioModel model;
    private final PhotographView view;
    private final RidePilot pilot;
    private final Object gesture = new Object();

    CameraHand(StudioModel model, PhotographView view, RidePilot pilot) {
        this.model = model;
        this.view = view;
        this.pilot = pilot;
    }

    @Override
    public Camera camera() {
        return model.studio().camera();
    }

    @Override
    public void hold(Camera camera) {
        Object of = pilot.isRiding() ? pilot.gesture() : gesture;
        try {
            model.adjust(FrontWindow.held(model.studio(), camera), of);
        } catch (InvalidPropertyException tooFar) {
            view.fail(tooFar);
        }
    }

    @Override
    public boolean canMove() {
        return !pilot.isRiding();
    }

    @Override
    public void letGo() {
        model.endGesture(gesture);
    }

    @Override
    public void askDistance(PicturePlace place, DoubleConsumer answer) {
        view.askDistance(place, answer);
    }
}
