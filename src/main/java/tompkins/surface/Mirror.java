package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A mirror on both sides. */
@Meaning("A mirror on both sides")
public record Mirror(
        @Meaning("Share of the light that is reflected, from 0 to 1; the rest is lost")
        double reflectance) implements Surface {

    /** A good silver mirror. */
    public static final Mirror DEFAULT = new Mirror(0.96);

    /** Checks the reflectance. */
    public Mirror {
        Transmission.required("reflectance", reflectance);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return Response.goesOn(reflected(ray, hit, reflectance), Colour.grey(reflectance));
    }

    /** The mirrored ray, with a share of the light. Its direction is made a unit vector again. */
    static Ray reflected(Ray ray, Hit hit, double share) {
        double twice = 2 * hit.cosine(ray);
        double dx = ray.dx - twice * hit.normalX;
        double dy = ray.dy - twice * hit.normalY;
        double dz = ray.dz - twice * hit.normalZ;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return ray.bent(hit, dx / length, dy / length, dz / length, share);
    }

    @Override
    public boolean continuesRays() {
        return true;
    }
}
