package tompkins.surface;

import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * The boundary of a transparent medium such as glass: light is bent by Snell's law and partly reflected by Fresnel's
 * equations, and needs more time inside; nothing is lost. Light sources shine through it unbent, so that glass throws
 * no shadow.
 */
@Meaning(
        "The boundary of a transparent medium such as glass: bends light and slows it down inside, reflects part of it,"
                + " loses nothing")
public record Refractive(
        @Meaning("Refractive index inside the object divided by that outside (glass in air: 1.5), from 1e-6 to 1e6")
        double indexRatio)
        implements Surface {

    /** Glass in air. */
    public static final Refractive DEFAULT = new Refractive(1.5);

    /**
     * After so many surfaces all light that can leave is let out: a ray that grazes the inside of a sphere would
     * otherwise run around in it until it meets the depth limit, and its light would be lost.
     */
    private static final int LONGEST_CAPTURE = 32;

    /** Far beyond all media, but small enough that times inside stay finite. */
    private static final double LARGEST_RATIO = 1e6;

    /** Checks the ratio: from 1e-6 to 1e6. */
    public Refractive {
        Require.within("indexRatio", indexRatio, 1 / LARGEST_RATIO, LARGEST_RATIO);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        double along = hit.cosine(ray);
        boolean entering = along < 0;
        double before = entering ? 1 : indexRatio;
        double behind = entering ? indexRatio : 1;
        double slowness = ray.lightSlowness() * behind / before;
        Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        double cosineBehind = Refraction.bend(direction, normal, before, behind, direction);
        double reflected = Refraction.reflectance(before, behind, Math.abs(along), cosineBehind);
        double transmitted = 1 - reflected;
        boolean caught = !entering && ray.depth >= LONGEST_CAPTURE && cosineBehind > 0;
        if (caught || ray.throughput * Math.min(reflected, transmitted) < Ray.FAINTEST) {
            // everything goes to the stronger part, so that as little light as possible goes the wrong way
            return Response.goesOn(
                    caught || reflected < transmitted
                            ? ray.bent(hit, direction.x, direction.y, direction.z, slowness, 1, 1)
                            : Mirror.reflected(ray, hit, 1),
                    Colour.WHITE);
        }
        Ray mirrored = Mirror.reflected(ray, hit, reflected);
        Ray bent = ray.bent(hit, direction.x, direction.y, direction.z, slowness, 1, transmitted);
        // the tracer loops over the stronger part, so that each level of recursion at least halves the light
        return reflected < transmitted
                ? split(tracer, mirrored, reflected, bent, transmitted)
                : split(tracer, bent, transmitted, mirrored, reflected);
    }

    private static Response split(Tracer tracer, Ray weaker, double weakerShare, Ray stronger, double strongerShare) {
        return new Response(tracer.colour(weaker).times(weakerShare), Colour.grey(strongerShare), stronger);
    }

    @Override
    public Shadow shadow() {
        return Shadow.NEVER;
    }

    @Override
    public boolean continuesRays() {
        return true;
    }
}
