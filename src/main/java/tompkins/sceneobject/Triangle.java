package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A flat piece with three corners. Coordinates: (0, 0) at the first corner, (1, 0) and (0, 1) at the others. */
@Meaning("A flat piece with three corners; (u, v) is (0, 0), (1, 0) and (0, 1) at the corners")
public record Triangle(
        @Meaning("Name of the object") String description,

        @Meaning(value = "First corner", unit = "length", place = true)
        Vector3dc first,

        @Meaning(value = "Second corner", unit = "length", place = true)
        Vector3dc second,

        @Meaning(value = "Third corner", unit = "length", place = true)
        Vector3dc third,

        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** In front of the camera. */
    public static final Triangle DEFAULT = new Triangle(
            "triangle",
            new Vector3d(-0.5, -0.5, 10),
            new Vector3d(0.5, -0.5, 10),
            new Vector3d(0, 0.5, 10),
            ColouredSurface.DEFAULT);

    /** Checks all values; the corners must not lie on one line. */
    public Triangle {
        first = Require.finite("first", first);
        second = Require.finite("second", second);
        third = Require.finite("third", third);
        if (Parallelogram.areParallel(second.sub(first, new Vector3d()), third.sub(first, new Vector3d()))) {
            throw new InvalidPropertyException(
                    "third",
                    "off the line through " + Require.text(first) + " and " + Require.text(second),
                    Require.text(third));
        }
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new FlatPrimitive(
                this,
                surface,
                FlatPrimitive.Outline.TRIANGLE,
                placement.point(first),
                placement.vector(second.sub(first, new Vector3d())),
                placement.vector(third.sub(first, new Vector3d()))));
    }
}
