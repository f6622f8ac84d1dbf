package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.primitive.SpherePrimitive;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A sphere. Coordinates: u once around the vertical axis, v from the lowest point (0) to the highest (1). */
@Meaning(
        "A sphere; u runs once around its vertical axis, from left to right seen from outside, v from the lowest point (0) to the highest (1)")
public record Sphere(
        @Meaning("Name of the object") String description,

        @Meaning(value = "Centre", unit = "length", place = true)
        Vector3dc centre,

        @Meaning(value = "Radius", unit = "length") double radius,
        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** In front of the camera. */
    public static final Sphere DEFAULT = new Sphere("sphere", new Vector3d(0, 0, 10), 1, ColouredSurface.DEFAULT);

    /** Checks all values. */
    public Sphere {
        centre = Require.finite("centre", centre);
        Require.positive("radius", radius);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new SpherePrimitive(this, surface, centre, radius, placement));
    }
}
