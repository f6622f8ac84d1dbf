package tompkins.ui.panel;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Aim;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.math.Vectors;
import tompkins.primitive.Bounds;
import tompkins.ray.Ray;
import tompkins.studio.FrontWindow;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Where a camera can look at once. What goes along with it turns with it. */
public enum CameraViews {
    /** In the direction in which the camera flies. */
    AHEAD,
    /** Back to where it comes from. */
    BACK,
    /** Towards the middle of all objects of the scene, as the camera sees it. */
    MIDDLE,
    /** At the horizon: the y axis of the scene points up in the picture. */
    LEVEL;

    /** The most objects that are used to find the middle of the scene. */
    private static final int MOST_OBJECTS = 100_000;

    private static final Vector3dc UP = new Vector3d(0, 1, 0);

    /** The studio whose camera looks there; empty if there is nothing to look at. */
    public Optional<Studio> of(Studio studio) {
        Camera camera = studio.camera();
        Vector3d ahead = new Vector3d(studio.velocity().direction());
        return switch (this) {
            case AHEAD -> Optional.of(FrontWindow.held(studio, Aim.along(camera, ahead)));
            case BACK -> Optional.of(FrontWindow.held(studio, Aim.along(camera, ahead.negate())));
            case MIDDLE -> middle(studio).map(way -> FrontWindow.held(studio, Aim.along(camera, way)));
            case LEVEL -> Optional.of(FrontWindow.held(studio, level(camera)));
        };
    }

    /** The direction in the camera frame of the middle of the scene. */
    private static Optional<Vector3d> middle(Studio studio) {
        List<Bounds> boxes = RenderPlan.of(studio).sceneBounds(MOST_OBJECTS);
        return boxes.stream()
                .reduce(Bounds::with)
                .map(all -> all.centre().sub(LensEvent.inScene(studio).position()))
                .filter(way -> way.length() > 0)
                .map(way -> {
                    Vector3d unit = Vectors.unit(way);
                    Ray ray =
                            studio.sceneFromCamera().inverse().transform(Ray.from(0, 0, 0, unit.x, unit.y, unit.z, 0));
                    return new Vector3d(ray.dx, ray.dy, ray.dz);
                });
    }

    private static Camera level(Camera camera) {
        Vector3d view = new Vector3d(camera.viewDirection());
        view.y = 0;
        if (view.length() < 1e-9 * camera.viewDirection().length()) {
            // straight up or down: towards what was at the lower or the upper edge of the picture
            view.set(camera.upDirection()).mul(camera.viewDirection().y() > 0 ? -1 : 1).y = 0;
        }
        return CameraMotion.turned(camera, Vectors.unit(view), UP);
    }
}
