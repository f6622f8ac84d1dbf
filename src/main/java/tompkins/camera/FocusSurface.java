package tompkins.camera;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;

/** The surface on which a camera is focused: any scene object, at rest in the camera frame. */
final class FocusSurface {

    /** All objects of usable size are nearer; from farther away no time can be worked out. */
    private static final double INFINITE = 1e60;

    private final List<Primitive> primitives;

    /**
     * The surface of an object.
     *
     * @throws tompkins.property.InvalidPropertyException if it is too large or too small to work with
     */
    FocusSurface(SceneObject object) {
        PrimitiveCollector collector = new PrimitiveCollector();
        collector.add("focus", object, Placement.NONE);
        primitives = collector.primitives();
    }

    /**
     * The inverse of the signed distance from the centre of the lens to the surface along a unit direction: that of the
     * nearest part in front, else of the nearest behind; 0 at infinity, which begins at 1e60; NaN if the line misses
     * the surface.
     */
    double inverseDistance(Vector3dc centre, Vector3dc direction) {
        Ray line = Ray.from(centre.x(), centre.y(), centre.z(), direction.x(), direction.y(), direction.z(), 0);
        double found = Double.NaN;
        for (Primitive primitive : primitives) {
            double inverse = primitive.inverseDistance(line);
            boolean nearer = inverse > 0 ? !(found >= inverse) : !(found > 0 || found <= inverse);
            if (Double.isFinite(inverse) && nearer) {
                found = inverse;
            }
        }
        // the zero keeps the side of the lens
        return Math.abs(found) * INFINITE < 1 ? 0 * found : found;
    }
}
