package optics;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.sceneobject.AddedObject;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A ring with a round tube. */
@Meaning("A ring with a round tube; u runs once around its axis, v once around the tube, both from 0 to 1")
public record Torus(
        @Meaning("Name of the object") String description,

        @Meaning(value = "Centre", unit = "length", place = true)
        Vector3dc centre,

        @Meaning("Vector along the axis, of any length but 0")
        Vector3dc axis,

        @Meaning(value = "Radius of the line in the middle of the tube", unit = "length")
        double radius,

        @Meaning(value = "Radius of the tube, below that of the ring", unit = "length")
        double tubeRadius,

        @Meaning("What it looks like") Surface surface)
        implements AddedObject {

    /** In front of the camera. */
    public static final Torus DEFAULT = new Torus();

    /** The usual ring. */
    public Torus() {
        this("torus", new Vector3d(0, 0, 10), new Vector3d(0, 1, -1), 1, 0.4, ColouredSurface.DEFAULT);
    }

    /** Checks all values. */
    public Torus {
        centre = Require.position("centre", centre);
        axis = Require.direction("axis", axis);
        Require.positive("radius", radius);
        Require.within("tubeRadius", tubeRadius, 1e-6 * radius, 0.999 * radius);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new TorusShape(this, placement));
    }
}
