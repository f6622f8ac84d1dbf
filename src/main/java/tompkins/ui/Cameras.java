package tompkins.ui;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Camera;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Ray;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Primitive;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.surface.ColouredSurface;

/** What the panels ask of any camera. */
final class Cameras {

    private Cameras() {}

    /** The direction of the middle of the picture, of any length. */
    static Vector3dc viewDirection(Camera camera) {
        return camera instanceof ThinLensCamera lens
                ? lens.viewDirection()
                : ((PanoramicCamera) camera).viewDirection();
    }

    /** The distance of the surface in focus along the middle of the picture; infinite if there is none. */
    static double focusDistance(Camera camera) {
        if (camera instanceof PanoramicCamera panoramic) {
            return panoramic.focusDistance();
        }
        ThinLensCamera lens = (ThinLensCamera) camera;
        Vector3dc centre = lens.position();
        Vector3d view = new Vector3d(lens.viewDirection()).normalize();
        Ray line = Ray.fromCamera(centre.x(), centre.y(), centre.z(), view.x, view.y, view.z, 0);
        double nearest = primitives(lens.focus()).stream()
                .mapToDouble(primitive -> primitive.inverseDistance(line))
                .filter(inverse -> inverse > 0)
                .max()
                .orElse(0);
        return 1 / nearest;
    }

    private static List<Primitive> primitives(SceneObject object) {
        return PrimitiveCollector.primitivesOf(object);
    }

    /** The camera focused on the plane across its view at a distance. */
    static Camera focusedAt(Camera camera, double distance) {
        if (camera instanceof PanoramicCamera) {
            return Records.with(camera, "focusDistance", distance);
        }
        if (!(distance != 0 && Double.isFinite(distance))) {
            throw new InvalidPropertyException("focusDistance", "a finite number, not 0", distance);
        }
        ThinLensCamera lens = (ThinLensCamera) camera;
        Vector3d view = new Vector3d(lens.viewDirection()).normalize();
        Vector3d point = new Vector3d(view).mul(distance).add(lens.position());
        return Records.with(camera, "focus", new Plane("focus", point, view, ColouredSurface.DEFAULT));
    }
}
