package tompkins.surface;

import org.joml.Vector3d;
import tompkins.math.Vectors;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/**
 * A thin lens that images every point to a point, whatever the aperture: a ray that is traced in the unit direction d
 * through the point S goes on along {@code d + (P - S) |d.n|/f}, with the centre P, the unit normal n and the focal
 * length f. The same law takes the light back from the other side. It changes neither the place, nor the time, nor the
 * frequency of the light: the delay of a lens belongs to an object and its image, and one ray knows neither.
 */
@Meaning("An ideal thin lens, for flat objects: it images every point to a point, whatever the aperture")
public record IdealLens(
        @Meaning(
                value = "Focal length, below 0 for a lens that spreads light, from 1e-50 to 1e50 in size",
                unit = "length")
        double focalLength,

        @Meaning("Surface coordinate u of the centre of the lens: 0.5 is the middle of a disc; planes count in lengths")
        double centreU,

        @Meaning("Surface coordinate v of the centre of the lens")
        double centreV,

        @Meaning("Share of the light that passes, from 0 to 1")
        double transmission)
        implements Surface {

    /** A burning glass. */
    public static final IdealLens DEFAULT = new IdealLens(1, 0.5, 0.5, 0.96);

    /** Checks all values. */
    public IdealLens {
        Require.sizeWithin("focalLength", focalLength, 1e-50, 1e50);
        Require.coordinate("centreU", centreU);
        Require.coordinate("centreV", centreV);
        Require.within("transmission", transmission, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        double cosine = Math.abs(hit.cosine(ray));
        Vector3d direction = toCentre(hit).mul(cosine / focalLength).add(ray.dx, ray.dy, ray.dz);
        if (!direction.isFinite() || direction.equals(0, 0, 0)) {
            return Response.ends(Colour.BLACK);
        }
        double turn = Vectors.length(direction);
        Vector3d unit = Vectors.unit(direction);
        // a solid angle is that of the slopes times the third power of the cosine, which is divided by the length
        double angleFactor = turn * Math.sqrt(turn);
        double width = ray.width + ray.spread * hit.distance;
        Ray next = ray.bent(hit, unit.x, unit.y, unit.z, transmission)
                .narrowed(angleFactor)
                .opened(-width * cosine / (focalLength * angleFactor));
        return Response.goesOn(next, Colour.grey(transmission));
    }

    /** From a hit to the centre, in the plane that touches the surface there. */
    private Vector3d toCentre(Hit hit) {
        SurfaceCoordinates at = hit.coordinates;
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        Vector3d acrossV = new Vector3d(at.vX(), at.vY(), at.vZ()).cross(normal);
        Vector3d acrossU = normal.cross(at.uX(), at.uY(), at.uZ());
        double area = acrossV.dot(at.uX(), at.uY(), at.uZ());
        return acrossV.mul((centreU - at.u()) / area).add(acrossU.mul((centreV - at.v()) / area));
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
