package tompkins.surface;

import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
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
        Require.within("reflectance", reflectance, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        if (!MediumWave.moves(ray.medium, ray.frame)) {
            return Response.goesOn(reflected(ray, hit, reflectance), Colour.grey(reflectance));
        }
        Ray mirrored = reflected(ray, MediumWave.of(ray, tracer), hit, reflectance, tracer);
        return mirrored == null ? Response.ends(Colour.BLACK) : Response.goesOn(mirrored, Colour.grey(reflectance));
    }

    /** The ray of the mirrored wave in a medium that moves past the mirror; null if none comes from it. */
    static Ray reflected(Ray ray, MediumWave wave, Hit hit, double fraction, Tracer tracer) {
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        MediumWave.Outgoing back = wave.outgoing(normal, -Math.signum(hit.cosine(ray)), ray.medium, ray.frame, tracer);
        return back == null || !wave.isMet() ? null : back.ray(ray, hit, fraction);
    }

    /** The mirrored ray, with a fraction of the light. Its direction is made a unit vector again. */
    static Ray reflected(Ray ray, Hit hit, double fraction) {
        double twice = 2 * hit.cosine(ray);
        double dx = ray.dx - twice * hit.normalX;
        double dy = ray.dy - twice * hit.normalY;
        double dz = ray.dz - twice * hit.normalZ;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return ray.bent(hit, dx / length, dy / length, dz / length, fraction);
    }

    @Override
    public Continuation continuation() {
        return Continuation.TURNED;
    }

    @Override
    public boolean keepsPhase() {
        return true;
    }

    @Override
    public Shadow shadow() {
        return Shadow.ALWAYS;
    }
}
