package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.primitive.FlatPrimitive;
import tompkins.primitive.Placement;
import tompkins.primitive.Primitive;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A flat piece with four straight sides. Coordinates: from 0 to 1 along both spans. */
@Meaning("A flat piece with four straight sides; u and v run from 0 to 1 along its spans")
public record Parallelogram(
        @Meaning("Name of the object") String description,

        @Meaning(value = "One corner", unit = "length", place = true)
        Vector3dc corner,

        @Meaning(value = "From the corner along the first side", unit = "length")
        Vector3dc spanU,

        @Meaning(value = "From the corner along the second side", unit = "length")
        Vector3dc spanV,

        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** A unit square in front of the camera. */
    public static final Parallelogram DEFAULT = new Parallelogram(
            "parallelogram",
            new Vector3d(-0.5, -0.5, 10),
            new Vector3d(1, 0, 0),
            new Vector3d(0, 1, 0),
            ColouredSurface.DEFAULT);

    /** Checks all values; the spans must not be parallel. */
    public Parallelogram {
        corner = Require.finite("corner", corner);
        spanU = Require.direction("spanU", spanU);
        spanV = Require.direction("spanV", spanV);
        if (areParallel(spanU, spanV)) {
            throw new InvalidPropertyException(
                    "spanV", "not parallel to spanU " + Require.text(spanU), Require.text(spanV));
        }
    }

    /** Whether two vectors span no usable area: one is 0 or infinite, or their angle is below 1e-9 radians. */
    static boolean areParallel(Vector3dc a, Vector3dc b) {
        Vector3d zero = new Vector3d();
        return !a.isFinite()
                || !b.isFinite()
                || a.equals(zero)
                || b.equals(zero)
                || !(Vectors.cross(Vectors.unit(a), Vectors.unit(b)).length() > 1e-9);
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(primitive(this, placement));
    }

    /** This parallelogram as the primitive of an object that it is, or is made into. */
    Primitive primitive(SceneObject object, Placement placement) {
        return new FlatPrimitive(
                object,
                surface,
                FlatPrimitive.Outline.PARALLELOGRAM,
                placement.point(corner),
                placement.vector(spanU),
                placement.vector(spanV));
    }
}
