package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A round rod or tube. Coordinates: u once around, v from start (0) to end (1); on caps as on a {@link Disc}. */
@Meaning(
        "A round rod, or a tube without caps; u runs once around, to the right seen from outside with the start below, v from start (0) to end (1)")
public record Cylinder(
        @Meaning("Name of the object") String description,

        @Meaning(value = "Centre of one end", unit = "length", place = true)
        Vector3dc start,

        @Meaning(value = "Centre of the other end", unit = "length", place = true)
        Vector3dc end,

        @Meaning(value = "Radius", unit = "length") double radius,
        @Meaning("Whether flat caps close the ends") boolean caps,
        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** An upright rod in front of the camera. */
    public static final Cylinder DEFAULT = new Cylinder(
            "cylinder", new Vector3d(0, -1, 10), new Vector3d(0, 1, 10), 0.5, true, ColouredSurface.DEFAULT);

    /** Checks all values; the ends must differ. */
    public Cylinder {
        start = Require.finite("start", start);
        end = Require.finite("end", end);
        requireDifferent("end", end, start);
        Require.positive("radius", radius);
    }

    static void requireDifferent(String property, Vector3dc point, Vector3dc other) {
        if (point.equals(other.x(), other.y(), other.z())) {
            throw new InvalidPropertyException(
                    property, "another point than " + Require.text(other), Require.text(point));
        }
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new CylinderPrimitive(this, surface, start, end, radius, caps, placement));
    }
}
