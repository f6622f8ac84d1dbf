package tompkins.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import tompkins.camera.Camera;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.GalileoWindow;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Surface;

/**
 * The window in front of the lens: a plane that moves with the camera, whose surface is a Lorentz or a Galileo window. If its
 * velocity is that of the camera, it stays so when the camera's changes.
 */
final class FrontWindow {

    /** What the plane is called. */
    static final String DESCRIPTION = "window in front of the lens";

    /** How far the plane is in front of the lens. */
    private static final double DISTANCE = 0.01;

    private FrontWindow() {}

    /** The window's surface, if there is one. */
    static Optional<Surface> of(Studio studio) {
        return studio.cameraFrame().stream()
                .filter(FrontWindow::isWindow)
                .map(object -> ((Plane) object).surface())
                .findFirst();
    }

    private static boolean isWindow(SceneObject object) {
        return object instanceof Plane plane
                && (plane.surface() instanceof LorentzWindow || plane.surface() instanceof GalileoWindow);
    }

    /** The studio with another surface of the window, which is put in place if there is none; without window if null. */
    static Studio with(Studio studio, Surface surface) {
        List<SceneObject> objects = new ArrayList<>();
        boolean found = false;
        for (SceneObject object : studio.cameraFrame()) {
            if (found || !isWindow(object)) {
                objects.add(object);
            } else if (surface != null) {
                Plane plane = (Plane) object;
                objects.add(new Plane(plane.description(), plane.point(), plane.normal(), surface));
                found = true;
            } else {
                found = true;
            }
        }
        if (!found && surface != null) {
            objects.add(0, plane(studio.camera(), surface));
        }
        return studio.withCameraFrame(objects);
    }

    private static Plane plane(Camera camera, Surface surface) {
        Vector3d view = new Vector3d(Cameras.viewDirection(camera)).normalize();
        return new Plane(DESCRIPTION, new Vector3d(view).mul(DISTANCE).add(camera.position()), view, surface);
    }

    /** The velocity of a window. */
    static Velocity velocity(Surface window) {
        return window instanceof LorentzWindow lorentz ? lorentz.velocity() : ((GalileoWindow) window).velocity();
    }

    /** The window with another velocity. */
    static Surface withVelocity(Surface window, Velocity velocity) {
        return Records.with(window, "velocity", velocity);
    }

    /** Whether the window has the velocity of the camera. */
    static boolean matches(Studio studio) {
        return of(studio)
                .map(FrontWindow::velocity)
                .filter(studio.velocity()::equals)
                .isPresent();
    }

    /** The studio with another velocity of the camera, and of the window if that matches. */
    static Studio withVelocity(Studio studio, Velocity velocity) {
        Studio moved = studio.withVelocity(velocity);
        return matches(studio) ? with(moved, withVelocity(of(studio).orElseThrow(), velocity)) : moved;
    }
}
