package tompkins.surface;

import java.util.stream.Stream;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Two surfaces at every point, each with its share of the light, as of threads too thin to be seen. */
@Meaning("Two surfaces at every point, each with its share of the light; with a clear one it is half transparent, and"
        + " throws no shadow")
public record Mixture(
        @Meaning("One surface") Surface first,
        @Meaning("The other surface") Surface second,
        @Meaning("Share of the second surface, from 0 to 1") double share)
        implements Surface {

    /** Half of white, half clear. */
    public static final Mixture DEFAULT =
            new Mixture(new ColouredSurface(Colour.WHITE, Colour.BLACK), Clear.DEFAULT, 0.5);

    /** Checks both surfaces and the share. */
    public Mixture {
        Require.present("first", first);
        Require.present("second", second);
        Require.within("share", share, 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return respond(first, second, share, ray, hit, tracer);
    }

    /** Each surface answers for its share of the bundle; the tracer loops over the larger share. */
    static Response respond(Surface first, Surface second, double share, Ray ray, Hit hit, Tracer tracer) {
        if (share == 0) {
            return first.respond(ray, hit, tracer);
        }
        if (share == 1) {
            return second.respond(ray, hit, tracer);
        }
        boolean continuesRays = first.continuesRays() || second.continuesRays();
        if (continuesRays && ray.throughput * Math.min(share, 1 - share) < Ray.FAINTEST) {
            // a share too faint to be followed is added to the larger one
            return (share < 0.5 ? first : second).respond(ray, hit, tracer);
        }
        Response ofFirst = first.respond(ray.dimmed(1 - share), hit, tracer).times(1 - share);
        Response ofSecond = second.respond(ray.dimmed(share), hit, tracer).times(share);
        return share < 0.5 ? ofFirst.plus(ofSecond, tracer) : ofSecond.plus(ofFirst, tracer);
    }

    @Override
    public boolean usesCoordinates() {
        return first.usesCoordinates() || second.usesCoordinates();
    }

    /** Where light passes one of both there is no shadow. */
    @Override
    public Shadow shadow() {
        Shadow ofFirst = share == 1 ? Shadow.ALWAYS : first.shadow();
        Shadow ofSecond = share == 0 ? Shadow.ALWAYS : second.shadow();
        boolean isNever = ofFirst == Shadow.NEVER || ofSecond == Shadow.NEVER;
        return isNever ? Shadow.NEVER : ofFirst.orElsewhere(ofSecond);
    }

    @Override
    public boolean throwsShadowAt(Ray ray, Hit hit) {
        return (share == 1 || first.throwsShadowAt(ray, hit)) && (share == 0 || second.throwsShadowAt(ray, hit));
    }

    @Override
    public Stream<Surface> parts() {
        return Stream.of(first, second).flatMap(Surface::parts);
    }

    @Override
    public boolean showsTime() {
        return first.showsTime() || second.showsTime();
    }

    @Override
    public boolean continuesRays() {
        return first.continuesRays() || second.continuesRays();
    }
}
