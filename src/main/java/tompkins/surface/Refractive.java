package tompkins.surface;

import java.util.List;
import org.joml.Vector3d;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Medium;
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

    /** After so many surfaces all light that can leave is let out, which would else run around inside and be lost. */
    private static final int LONGEST_CAPTURE = 32;

    /** What rounding leaves of an index of 1. */
    private static final double ROUNDING = 1e-12;

    /** Far beyond all media, but small enough that times inside stay finite. */
    private static final double LARGEST_RATIO = 1e6;

    /** Checks the ratio: from 1e-6 to 1e6. */
    public Refractive {
        Require.within("indexRatio", indexRatio, 1 / LARGEST_RATIO, LARGEST_RATIO);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        boolean entering = hit.cosine(ray) < 0;
        Medium medium = !tracer.keepsMedia() ? null : entering ? inside(ray.medium, ray) : outside(ray.medium, ray);
        return respond(ray, hit, entering ? 1 : indexRatio, entering ? indexRatio : 1, medium, tracer);
    }

    /**
     * What becomes of a ray where it leaves some media and enters others at one place: one boundary parts what lies
     * before all of them from what lies behind.
     *
     * @param hit the hit on one of the boundaries
     */
    public static Response respond(Ray ray, Hit hit, List<Refractive> left, List<Refractive> entered, Tracer tracer) {
        Medium medium = ray.medium;
        double before = 1;
        double behind = 1;
        for (Refractive each : left) {
            before *= each.indexRatio;
            medium = each.outside(medium, ray);
        }
        for (Refractive each : entered) {
            behind *= each.indexRatio;
            medium = each.inside(medium, ray);
        }
        return respond(ray, hit, before, behind, tracer.keepsMedia() ? medium : null, tracer);
    }

    /** Whether the index behind is that before, but for rounding, if this is their ratio. */
    public static boolean isNothing(double ratio) {
        return Math.abs(ratio - 1) < ROUNDING;
    }

    private static Response respond(Ray ray, Hit hit, double before, double behind, Medium medium, Tracer tracer) {
        if (MediumWave.moves(ray.medium, ray.frame) || MediumWave.moves(medium, ray.frame)) {
            return respondToWave(ray, hit, before, medium, tracer);
        }
        double along = hit.cosine(ray);
        double slowness =
                !tracer.keepsMedia() ? ray.lightSlowness() * behind / before : medium == null ? 1 : medium.index();
        Vector3d direction = new Vector3d(ray.dx, ray.dy, ray.dz);
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        double cosineBehind = Refraction.bend(direction, normal, before, behind, direction);
        double reflected = Refraction.reflectance(before, behind, Math.abs(along), cosineBehind);
        Ray mirrored = Mirror.reflected(ray, hit, 1);
        Ray bent = ray.bent(hit, direction.x, direction.y, direction.z, 1)
                .slowed(slowness)
                .in(medium);
        return split(ray, before == 1, mirrored, bent, reflected, tracer);
    }

    /** The medium inside, which rests in the frame of the boundary. */
    private Medium inside(Medium around, Ray ray) {
        double index = around == null ? 1 : around.index();
        return new Medium(index * indexRatio, ray.frame, around);
    }

    /** The medium outside; null for vacuum. A ray that has begun in a medium does not know what is around that. */
    private Medium outside(Medium medium, Ray ray) {
        double index = (medium == null ? 1 : medium.index()) / indexRatio;
        Medium outer = medium != null && medium.frame() == ray.frame ? medium.outer() : null;
        // it may have come into this medium from another one beside it
        if (outer != null && isNothing(outer.index() / index)) {
            return outer;
        }
        return isNothing(index) ? null : new Medium(index, ray.frame, null);
    }

    /** Where a medium moves past the boundary it is the wave that is bent, and mirrored. */
    private static Response respondToWave(Ray ray, Hit hit, double before, Medium medium, Tracer tracer) {
        MediumWave wave = MediumWave.of(ray, tracer);
        if (!wave.isMet()) {
            return Response.ends(Colour.BLACK);
        }
        Vector3d normal = new Vector3d(hit.normalX, hit.normalY, hit.normalZ);
        Ray mirrored = Mirror.reflected(ray, wave, hit, 1, tracer);
        MediumWave.Outgoing through = wave.outgoing(normal, Math.signum(hit.cosine(ray)), medium, ray.frame, tracer);
        if (mirrored == null && through == null) {
            return Response.ends(Colour.BLACK);
        }
        if (mirrored == null || through == null) {
            Ray only = through == null ? mirrored : through.ray(ray, hit, 1).in(medium);
            return Response.goesOn(only, Colour.WHITE);
        }
        double cosine = Math.abs(wave.direction().dot(normal));
        double cosineBehind = Math.abs(through.vector().dot(normal)) / through.index();
        double reflected = Refraction.reflectance(wave.index(), through.index(), cosine, cosineBehind);
        return split(ray, before == 1, mirrored, through.ray(ray, hit, 1).in(medium), reflected, tracer);
    }

    /** Mirrors a part of the light; everything goes to the stronger part where the other is too faint. */
    private static Response split(Ray ray, boolean entering, Ray mirrored, Ray bent, double reflected, Tracer tracer) {
        double transmitted = 1 - reflected;
        boolean caught = !entering && ray.depth >= LONGEST_CAPTURE && transmitted > 0;
        if (caught || ray.throughput * Math.min(reflected, transmitted) < Ray.FAINTEST) {
            return Response.goesOn(caught || reflected < transmitted ? bent : mirrored, Colour.WHITE);
        }
        // the tracer loops over the stronger part, so that each level of recursion at least halves the light
        return reflected < transmitted
                ? split(tracer, mirrored.dim(reflected), reflected, bent.dim(transmitted), transmitted)
                : split(tracer, bent.dim(transmitted), transmitted, mirrored.dim(reflected), reflected);
    }

    private static Response split(
            Tracer tracer, Ray weaker, double weakerFraction, Ray stronger, double strongerFraction) {
        return new Response(tracer.colour(weaker).times(weakerFraction), Colour.grey(strongerFraction), stronger);
    }

    @Override
    public boolean canTurn() {
        return false;
    }

    @Override
    public Continuation continuation() {
        return Continuation.TURNED;
    }

    @Override
    public boolean keepsPhase() {
        return true;
    }
}
