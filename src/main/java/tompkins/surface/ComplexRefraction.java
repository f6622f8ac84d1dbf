package tompkins.surface;

import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * A sheet that refracts light as a boundary with a complex ratio m of the refractive indices would (Sundar, Hamilton
 * and Courtial 2009). The part of a unit direction along the surface is a complex number c, of its parts along two axes
 * at right angles. A ray that is traced into the surface goes on with {@code c/m}, one that is traced out with {@code c
 * m}, which takes the same light back. The size of m bends as Snell's law does, and its argument turns about the
 * normal. Where nothing of the direction would be left along the normal, all light is reflected. It changes neither the
 * place, nor the time, nor the frequency.
 */
@Meaning(
        "A sheet that bends light as Snell's law says and also turns it about the normal, as with a complex ratio of the"
                + " refractive indices; it mirrors nothing but what is reflected totally, and delays nothing")
public record ComplexRefraction(
        @Meaning("Size of the index behind the surface divided by the one in front of it, from 1e-6 to 1e6; with 1 the"
                + " angle to the normal stays")
        double indexRatio,

        @Meaning(
                value = "By how much a line of sight that enters is turned about the normal, anticlockwise seen from"
                        + " outside; one that leaves is turned back. It is minus the argument of the ratio",
                unit = "degrees")
        double rotationDegrees,

        @Meaning("Share of the light that passes, from 0 to 1")
        double transmission)
        implements Surface {

    /** A sheet that turns by a right angle, and dims a little. */
    public static final ComplexRefraction DEFAULT = new ComplexRefraction(1, 90, 0.96);

    /** The largest ratio, and the inverse of the smallest: rays stay far from the limits of a double. */
    private static final double LARGEST_RATIO = 1e6;

    /** Checks all values. */
    public ComplexRefraction {
        Require.within("indexRatio", indexRatio, 1 / LARGEST_RATIO, LARGEST_RATIO);
        Require.finite("rotationDegrees", rotationDegrees);
        Require.within("transmission", transmission, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        boolean turnsNothing = indexRatio == 1 && rotationDegrees == 0;
        Ray next = turnsNothing ? ray.straightOn(hit, transmission) : turned(ray, hit);
        return Response.goesOn(next, Colour.grey(transmission));
    }

    private Ray turned(Ray ray, Hit hit) {
        Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        double along = hit.cosine(ray);
        boolean enters = along < 0;
        double behind = enters ? indexRatio : 1;
        double before = enters ? 1 : indexRatio;
        double cosine = Refraction.bend(direction, normal, before, behind, direction);
        if (cosine == 0 || along == 0) {
            return Mirror.reflected(ray, hit, transmission);
        }
        Vector3d across = new Vector3d(normal).mul(Math.copySign(cosine, along));
        Vector3d tangential = direction.sub(across, new Vector3d());
        double angle = Math.toRadians(enters ? rotationDegrees : -rotationDegrees);
        Vector3d turned = tangential.cross(normal, new Vector3d()).mul(Math.sin(angle));
        turned.fma(Math.cos(angle), tangential).add(across).normalize();
        // a solid angle is that of the parts along the surface, divided by the cosine
        double angleFactor = behind / before * Math.sqrt(cosine / Math.abs(along));
        return ray.bent(hit, turned.x, turned.y, turned.z, transmission).narrowed(angleFactor);
    }

    @Override
    public Continuation continuation() {
        return Continuation.TURNED;
    }
}
