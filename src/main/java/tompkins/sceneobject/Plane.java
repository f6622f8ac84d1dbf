package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.RigidMotion;
import tompkins.primitive.Placement;
import tompkins.primitive.PlanePrimitive;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/**
 * An infinite plane. Coordinates: lengths from the point, u along the x axis laid into the plane (along z where the
 * plane stands across x), v across; on a floor u is x and v is z.
 */
@Meaning("An infinite plane; u and v are lengths from its point, on a floor along x and z")
public record Plane(
        @Meaning("Name of the object") String description,

        @Meaning(value = "A point of the plane, where the coordinates start", unit = "length", place = true)
        Vector3dc point,

        @Meaning("Direction of the normal, of any length") Vector3dc normal,
        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** A floor one unit below the camera. */
    public static final Plane DEFAULT =
            new Plane("plane", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), ColouredSurface.DEFAULT);

    /** Checks all values. */
    public Plane {
        point = Require.finite("point", point);
        normal = Require.direction("normal", normal);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new PlanePrimitive(this, surface, point, normal, placement));
    }

    @Override
    public Plane moved(RigidMotion motion) {
        return new Plane(description, motion.place(point), motion.direction(normal), surface);
    }
}
