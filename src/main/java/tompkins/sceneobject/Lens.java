package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.primitive.CapPrimitive;
import tompkins.primitive.CylinderPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;

/**
 * A lens between two spheres, or planes, with a cylinder as its rim. A thick lens of glass has the focal length f with
 * {@code 1/f = (n - 1)(c1 + c2 - (n - 1) c1 c2 t/n)}, where c1 and c2 are the curvatures of its faces, both above 0 if
 * they bulge, and t is its thickness in the middle. Coordinates: on each face as on a {@link Disc}, on the rim as on a
 * {@link Cylinder} from the back to the front.
 */
@Meaning("A lens between two spheres, or planes, with a cylinder as its rim; u and v on its faces are those of a disc,"
        + " on its rim those of a cylinder from back to front")
public record Lens(
        @Meaning("Name of the object") String description,

        @Meaning(value = "The middle of its rim", unit = "length", place = true)
        Vector3dc centre,

        @Meaning("Direction of its axis, from the back to the front, of any length")
        Vector3dc axis,

        @Meaning(value = "Radius of its rim", unit = "length")
        double radius,

        @Meaning(value = "Thickness at its rim; 0 for a sharp edge", unit = "length")
        double edgeThickness,

        @Meaning(
                value = "Curvature of the front: 1 divided by the radius of its sphere, which is at least that of the"
                        + " rim. Above 0 the front bulges, below 0 it is hollow, with 0 it is flat",
                unit = "1/length")
        double frontCurvature,

        @Meaning(value = "Curvature of the back, above 0 if that bulges", unit = "1/length")
        double backCurvature,

        @Meaning("What it is made of, or looks like") Surface surface)
        implements SceneObject {

    /** A burning glass in front of the camera. */
    public static final Lens DEFAULT =
            new Lens("lens", new Vector3d(0, 0, 10), new Vector3d(0, 0, -1), 1, 0, 0.3, 0.3, Refractive.DEFAULT);

    /** Checks all values; the faces may not touch inside the rim. */
    public Lens {
        centre = Require.finite("centre", centre);
        axis = Require.direction("axis", axis);
        Require.positive("radius", radius);
        requireCap("frontCurvature", frontCurvature, radius);
        requireCap("backCurvature", backCurvature, radius);
        Require.notNegative("edgeThickness", edgeThickness);
        double rises = CapPrimitive.rise(radius, frontCurvature) + CapPrimitive.rise(radius, backCurvature);
        if (!(edgeThickness + rises > 0)) {
            throw new InvalidPropertyException(
                    "edgeThickness",
                    "above " + NumberText.of(0 - rises) + ", so that the faces do not touch",
                    NumberText.of(edgeThickness));
        }
    }

    /** A sphere of this curvature is at least as large as the rim. */
    private static void requireCap(String property, double curvature, double radius) {
        double most = 1 / radius;
        if (!(Math.abs(curvature) <= most)) {
            throw new InvalidPropertyException(
                    property, "from " + NumberText.of(-most) + " to " + NumberText.of(most), curvature);
        }
    }

    @Override
    public double primitiveCount() {
        return edgeThickness > 0 ? 3 : 2;
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        Vector3d forwards = Vectors.unit(axis);
        Vector3d backwards = forwards.negate(new Vector3d());
        Vector3d front = new Vector3d(centre).fma(edgeThickness / 2, forwards);
        Vector3d back = new Vector3d(centre).fma(edgeThickness / 2, backwards);
        collector.add(new CapPrimitive(this, surface, front, forwards, radius, frontCurvature, placement));
        collector.add(new CapPrimitive(this, surface, back, backwards, radius, backCurvature, placement));
        // beside a distant centre rounding may leave nothing of it
        if (!front.equals(back)) {
            collector.add(new CylinderPrimitive(this, surface, back, front, radius, false, placement));
        }
    }
}
