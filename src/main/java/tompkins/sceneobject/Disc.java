package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A flat disc. Coordinates: 0 to 1 across the square around it, to the right and up seen from its normal. */
@Meaning(
        "A flat disc; u and v run from 0 to 1 across the square around it, to the right and up seen from the side of its normal")
public record Disc(
        @Meaning("Name of the object") String description,

        @Meaning(value = "Centre", unit = "length", place = true)
        Vector3dc centre,

        @Meaning("Direction of the normal, of any length") Vector3dc normal,
        @Meaning(value = "Radius", unit = "length") double radius,
        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** In front of the camera, facing it. */
    public static final Disc DEFAULT =
            new Disc("disc", new Vector3d(0, 0, 10), new Vector3d(0, 0, -1), 1, ColouredSurface.DEFAULT);

    /** Checks all values. */
    public Disc {
        centre = Require.finite("centre", centre);
        normal = Require.direction("normal", normal);
        Require.positive("radius", radius);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(primitive(this, placement));
    }

    /** This disc as the primitive of an object that it is, or is part of. */
    Primitive primitive(SceneObject object, Placement placement) {
        Vector3d unit = Vectors.unit(normal);
        Vector3d up = Vectors.upOnFace(unit).mul(radius);
        Vector3d right = unit.cross(up, new Vector3d());
        Vector3d corner = centre.sub(right, new Vector3d()).sub(up);
        return new FlatPrimitive(
                object,
                surface,
                FlatPrimitive.Outline.ELLIPSE,
                placement.point(corner),
                placement.vector(right.mul(2)),
                placement.vector(up.mul(2)),
                placement.direction(unit));
    }
}
