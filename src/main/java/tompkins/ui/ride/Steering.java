package tompkins.ui.ride;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Aim;
import tompkins.camera.Aim.PicturePosition;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.camera.ThinLensCamera;
import tompkins.math.Vectors;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.FrontWindow;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.PhotographView;

/**
 * Turns and moves the camera of a picture by hand: as a person on board does by turning the head and stepping aside.
 * All changes up to {@link #letGo} are one gesture, a step of the history, unless they are part of a ride.
 */
final class Steering {

    /** Share of the distance by which a notch of the wheel brings nearer. */
    private static final double STEP = 0.1;

    /** Factor of the field of view for a notch of the wheel. */
    private static final double ZOOM = 1.1;

    /** Share of the field of view by which a key turns. */
    private static final double TURN = 0.05;

    /** A point that is seen more obliquely than this is not moved with the mouse. */
    private static final double OBLIQUE = 0.05;

    private final StudioModel model;
    private final PhotographView view;
    private final RidePilot pilot;
    private final Object gesture = new Object();

    /** The distance of what is under the hand; NaN while it is unknown. */
    private double distance = Double.NaN;

    /** What waits for the distance, which was asked for with the first. */
    private final List<Runnable> waiting = new ArrayList<>();

    /** Whether the gesture ends as soon as the distance has come. */
    private boolean ending;

    Steering(StudioModel model, PhotographView view, RidePilot pilot) {
        this.model = model;
        this.view = view;
        this.pilot = pilot;
    }

    private Camera camera() {
        return model.studio().camera();
    }

    /** Turns the camera so that what was seen at one place of the picture is seen at another. */
    void turn(PicturePosition from, PicturePosition to) {
        change(camera -> Aim.at(camera, from.direction(camera), to));
    }

    /** Turns the camera to what is at a place. */
    void centre(PicturePosition place) {
        change(camera -> Aim.along(camera, place.direction(camera)));
        letGo();
    }

    /** Changes the field of view about a place, by notches of the wheel towards the user. */
    void zoom(PicturePosition place, double notches) {
        change(camera -> Aim.zoomed(camera, Math.pow(ZOOM, notches), place));
    }

    /** Turns by a part of the field of view, to the right and up. */
    void turn(int right, int up) {
        double angle = TURN * Math.toRadians(camera().horizontalAngleDegrees());
        change(new Aim(right * angle, up * angle)::turn);
    }

    /** Moves the lens sideways and up, so that what was seen at one place is seen near another. */
    void slide(PicturePosition from, PicturePosition to) {
        whenFar(from, () -> {
            Camera camera = camera();
            Vector3d first = from.direction(camera);
            Vector3d second = to.direction(camera);
            // the plane in which it moves: across the view of a lens, across the first direction of a panorama
            Vector3d across = camera instanceof ThinLensCamera ? Vectors.unit(camera.viewDirection()) : first;
            double oblique = second.dot(across);
            if (oblique > OBLIQUE) {
                double ratio = first.dot(across) / oblique;
                move(new Vector3d(first).fma(-ratio, second).mul(distance));
            }
        });
    }

    /** Moves the lens sideways and up, by a part of what the picture shows at the distance of a place. */
    void slide(PicturePosition place, int right, int up) {
        whenFar(place, () -> {
            Camera camera = camera();
            double step = distance * Math.min(1, TURN * Math.toRadians(camera.horizontalAngleDegrees()));
            move(new Vector3d(camera.rightDirection()).mul(right * step).fma(up * step, camera.upDirection()));
        });
    }

    /** Moves the lens towards what is at a place, by notches of the wheel towards the user. */
    void approach(PicturePosition place, double notches) {
        whenFar(place, () -> {
            double left = distance * Math.pow(1 - STEP, -notches);
            move(place.direction(camera()).mul(distance - left));
            distance = left;
        });
    }

    private void move(Vector3dc way) {
        // on a ride the camera is turned on board, and not moved
        if (!pilot.isRiding()) {
            change(camera -> CameraMotion.shifted(camera, way));
        }
    }

    private void change(UnaryOperator<Camera> change) {
        try {
            Object of = pilot.isRiding() ? pilot.gesture() : gesture;
            model.look(FrontWindow.held(model.studio(), change.apply(camera())), of);
        } catch (InvalidPropertyException tooFar) {
            view.fail(tooFar);
        }
    }

    /** Does something as soon as the distance of what is seen at a place is known. */
    private void whenFar(PicturePosition place, Runnable action) {
        if (Double.isFinite(distance)) {
            action.run();
            return;
        }
        if (ending) {
            // the answer to the previous gesture never came
            forget();
        }
        waiting.add(action);
        if (waiting.size() == 1) {
            view.askDistance(place, this::answer);
        }
    }

    private void answer(double far) {
        if (waiting.isEmpty()) {
            return;
        }
        distance = far;
        waiting.forEach(Runnable::run);
        waiting.clear();
        if (ending) {
            letGo();
        }
    }

    /** The gesture is over. */
    void letGo() {
        ending = !waiting.isEmpty();
        if (!ending) {
            forget();
            model.endGesture(gesture);
        }
    }

    private void forget() {
        distance = Double.NaN;
        ending = false;
        waiting.clear();
    }
}
