package tompkins.camera;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.primitive.PlanePrimitive;
import tompkins.primitive.Primitive;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;

/** The surface on which a camera is focused: any scene object, at rest in the camera frame. */
final class FocusSurface {

    /** All objects of usable size are nearer; from farther away no time can be worked out. */
    private static final double INFINITE = 1e60;

    /** Planes, which are met at infinity, too. */
    private final List<PlanePrimitive> planes;

    private final ObjectTree others;

    /** Memory of each thread for a search. */
    private final ThreadLocal<NearestHit> nearest = ThreadLocal.withInitial(() -> new NearestHit(new RayCounts()));

    /**
     * The surface of an object.
     *
     * @throws tompkins.property.InvalidPropertyException if it is too large or too small to work with
     */
    FocusSurface(SceneObject object) {
        Map<Boolean, List<Primitive>> byPlane =
                primitives(object).stream().collect(Collectors.partitioningBy(PlanePrimitive.class::isInstance));
        planes = byPlane.get(true).stream().map(PlanePrimitive.class::cast).toList();
        others = new ObjectTree(byPlane.get(false));
    }

    /**
     * What the surface of an object consists of.
     *
     * @throws tompkins.property.InvalidPropertyException if it is too large or too small to work with
     */
    static List<Primitive> primitives(SceneObject object) {
        PrimitiveCollector collector = new PrimitiveCollector();
        collector.add("focus", object, Placement.NONE);
        return collector.primitives(0);
    }

    /**
     * The inverse of the signed distance from the centre of the lens to the surface along a unit direction: that of the
     * nearest part in front, else of the nearest behind; 0 at infinity, which begins at 1e60; NaN if the line misses
     * the surface.
     */
    double inverseDistance(Vector3dc centre, Vector3dc direction) {
        Ray line = Ray.from(centre.x(), centre.y(), centre.z(), direction.x(), direction.y(), direction.z(), 0);
        double found = others.size() == 0 ? Double.NaN : inverseDistanceOfOthers(line);
        for (PlanePrimitive plane : planes) {
            double inverse = plane.inverseDistance(line);
            boolean nearer = inverse > 0 ? !(found >= inverse) : !(found > 0 || found <= inverse);
            if (Double.isFinite(inverse) && nearer) {
                found = inverse;
            }
        }
        // the zero keeps the side of the lens
        return Math.abs(found) * INFINITE < 1 ? 0 * found : found;
    }

    private double inverseDistanceOfOthers(Ray line) {
        NearestHit hit = nearest.get();
        if (others.nearest(line, hit)) {
            return 1 / hit.distance();
        }
        Ray backwards = Ray.from(line.x, line.y, line.z, -line.dx, -line.dy, -line.dz, 0);
        return others.nearest(backwards, hit) ? -1 / hit.distance() : Double.NaN;
    }
}
