package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.EllipsoidPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/**
 * An ellipsoid along the axes; {@link Placed} turns it. Coordinates: those of the {@link Sphere} of radius 1 that
 * becomes the ellipsoid where its lengths along x, y and z are multiplied by the semi-axes.
 */
@Meaning("An ellipsoid along the axes, which Placed can turn: a sphere of radius 1 that is stretched along x, y and z,"
        + " together with its u and v")
public record Ellipsoid(
        @Meaning("Name of the object") String description,

        @Meaning(value = "Centre", unit = "length", place = true)
        Vector3dc centre,

        @Meaning(value = "The semi-axes: half its lengths along x, y and z", unit = "length")
        Vector3dc semiAxes,

        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** In front of the camera. */
    public static final Ellipsoid DEFAULT =
            new Ellipsoid("ellipsoid", new Vector3d(0, 0, 10), new Vector3d(1.5, 1, 1), ColouredSurface.DEFAULT);

    /** Checks all values; each semi-axis must be above 0. */
    public Ellipsoid {
        centre = Require.finite("centre", centre);
        semiAxes = Require.finite("semiAxes", semiAxes);
        if (!(semiAxes.x() > 0 && semiAxes.y() > 0 && semiAxes.z() > 0)) {
            throw new InvalidPropertyException("semiAxes", "three numbers above 0", Require.text(semiAxes));
        }
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new EllipsoidPrimitive(this, surface, centre, semiAxes, placement));
    }
}
