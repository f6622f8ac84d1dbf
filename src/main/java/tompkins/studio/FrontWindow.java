package tompkins.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.math.RigidMotion;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.Velocity;
import tompkins.surface.FrameWindow;
import tompkins.surface.Surface;

/**
 * The window in front of the lens: the first object that moves with the camera and has the surface of a Lorentz or a
 * Galileo window. If its velocity is that of the camera, it follows when the velocity of the camera changes.
 */
public final class FrontWindow {

    /** The name of a plane that is put there. */
    static final String DESCRIPTION = "window in front of the lens";

    /** How far the plane is in front of the lens. */
    private static final double DISTANCE = 0.01;

    /** The name of the component that holds the surface of an object. */
    private static final String SURFACE = "surface";

    private FrontWindow() {}

    /** The window's surface, if there is one. */
    public static Optional<FrameWindow> of(Studio studio) {
        return studio.cameraFrame().stream()
                .flatMap(object -> window(object).stream())
                .findFirst();
    }

    private static Optional<FrameWindow> window(SceneObject object) {
        return Descriptions.find(object.getClass(), SURFACE)
                .map(component -> Descriptions.value(component, object))
                .filter(FrameWindow.class::isInstance)
                .map(FrameWindow.class::cast);
    }

    /** The studio with another surface of the window, which is new if there was none; null takes it away. */
    public static Studio with(Studio studio, Surface surface) {
        List<SceneObject> objects = new ArrayList<>();
        boolean found = false;
        for (SceneObject object : studio.cameraFrame()) {
            boolean first = !found && window(object).isPresent();
            found |= first;
            if (!first) {
                objects.add(object);
            } else if (surface != null) {
                objects.add(Descriptions.with(object, SURFACE, surface));
            }
        }
        if (!found && surface != null) {
            objects.add(0, plane(studio.camera(), surface));
        }
        return studio.withCameraFrame(objects);
    }

    private static Plane plane(Camera camera, Surface surface) {
        Vector3d view = Vectors.unit(camera.viewDirection());
        return new Plane(DESCRIPTION, new Vector3d(view).mul(DISTANCE).add(camera.position()), view, surface);
    }

    /**
     * The studio with its camera turned or moved on board: the window stays in front of the lens; everything else that
     * moves with the camera stays where it is on board.
     */
    public static Studio held(Studio studio, Camera moved) {
        RigidMotion motion = CameraMotion.between(studio.camera(), moved);
        List<SceneObject> objects = new ArrayList<>(studio.cameraFrame());
        for (int i = 0; i < objects.size(); i++) {
            if (window(objects.get(i)).isPresent()) {
                objects.set(i, objects.get(i).moved(motion));
                return studio.withCamera(moved).withCameraFrame(objects);
            }
        }
        return studio.withCamera(moved);
    }

    /** Whether the window has the velocity of the camera. */
    public static boolean matches(Studio studio) {
        return of(studio)
                .map(FrameWindow::velocity)
                .filter(studio.velocity()::equals)
                .isPresent();
    }

    /** The studio with another velocity of the camera, and of the window if that matches. */
    public static Studio withVelocity(Studio studio, Velocity velocity) {
        return following(studio, studio.withVelocity(velocity));
    }

    /**
     * A studio after a change; a window that matched before and was not changed itself has the velocity of the camera
     * again.
     */
    public static Studio following(Studio before, Studio after) {
        Optional<FrameWindow> window = of(after);
        boolean follows = matches(before) && !matches(after) && window.equals(of(before));
        return follows ? with(after, window.orElseThrow().withVelocity(after.velocity())) : after;
    }
}
