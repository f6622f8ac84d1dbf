package tompkins.surface;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * A sheet of tiny telescopes (Hamilton and Courtial 2009, arXiv:0901.3250): two arrays of lenslets, one focal length of
 * each apart, with axes along the normal. A direction has the slopes s, its parts along the axes u and v of the surface
 * divided by that along the normal. A ray that is traced out of the front goes on with {@code (s - delta)/eta}, where
 * {@code eta = -f2/f1}; a ray that is traced into it with {@code eta s - delta}, which takes the same light back. A
 * flat sheet images every point, whatever the aperture. It changes neither the place, nor the time, nor the frequency.
 */
@Meaning(
        "A sheet of tiny telescopes, two arrays of confocal lenslets: a line of sight that leaves through the front goes"
                + " on with the slopes (s - delta)/eta to the normal, one that enters there with eta s - delta")
public record ConfocalLensletArray(
        @Meaning("How many times as large things look along u, seen from behind the sheet; below 0 the wrong way round;"
                + " from 1e-6 to 1e6 in size")
        double etaU,

        @Meaning("The same along v") double etaV,

        @Meaning("The slope along u at which the direction of the normal is seen from behind, from -1e6 to 1e6")
        double deltaU,

        @Meaning("The same along v") double deltaV,

        @Meaning("Share of the light that passes, from 0 to 1")
        double transmission)
        implements Surface {

    /** A sheet that magnifies twice, and dims a little. */
    public static final ConfocalLensletArray DEFAULT = new ConfocalLensletArray(2, 2, 0, 0, 0.96);

    /** The largest magnification, and the inverse of the smallest: rays stay far from the limits of a double. */
    private static final double LARGEST = 1e6;

    /** Checks all values. */
    public ConfocalLensletArray {
        Require.sizeWithin("etaU", etaU, 1 / LARGEST, LARGEST);
        Require.sizeWithin("etaV", etaV, 1 / LARGEST, LARGEST);
        Require.within("deltaU", deltaU, -LARGEST, LARGEST);
        Require.within("deltaV", deltaV, -LARGEST, LARGEST);
        Require.within("transmission", transmission, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        boolean turnsNothing = etaU == 1 && etaV == 1 && deltaU == 0 && deltaV == 0;
        Ray next = turnsNothing ? ray.straightOn(hit, transmission) : turned(ray, hit);
        return Response.goesOn(next, Colour.grey(transmission));
    }

    private Ray turned(Ray ray, Hit hit) {
        Matrix3d own = WindowAxes.ofSurface(hit);
        Vector3d direction = own.transformTranspose(new Vector3d(ray.dx, ray.dy, ray.dz));
        double along = Math.abs(direction.z);
        boolean outwards = direction.z > 0;
        direction.x = outwards ? (direction.x - deltaU * along) / etaU : etaU * direction.x - deltaU * along;
        direction.y = outwards ? (direction.y - deltaV * along) / etaV : etaV * direction.y - deltaV * along;
        double length = direction.length();
        own.transform(direction.div(length));
        // a solid angle is that of the slopes times the third power of the cosine, which is divided by the length
        double narrower = outwards ? Math.abs(etaU * etaV) : 1 / Math.abs(etaU * etaV);
        double angleFactor = length * Math.sqrt(narrower * length);
        return ray.bent(hit, direction.x, direction.y, direction.z, transmission)
                .narrowed(angleFactor);
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }

    @Override
    public Continuation continuation() {
        return Continuation.TURNED;
    }
}
