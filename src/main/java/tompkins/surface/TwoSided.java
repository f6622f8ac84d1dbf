package tompkins.surface;

import java.util.stream.Stream;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * Two surfaces, one on either side: what a ray meets is decided by the side from which it comes. Glass is refused,
 * because a medium has two sides of its own.
 */
@Meaning("One surface on the outside of an object, another one on its inside; on flat pieces the outside is the front")
public record TwoSided(
        @Meaning("What it looks like from outside") Surface outside,

        @Meaning("What it looks like from inside") Surface inside)
        implements Surface {

    /** White outside, dark grey inside. */
    public static final TwoSided DEFAULT = new TwoSided(
            new ColouredSurface(Colour.WHITE, Colour.BLACK), new ColouredSurface(Colour.grey(0.2), Colour.BLACK));

    /** Checks both surfaces. */
    public TwoSided {
        requireNoGlass("outside", outside);
        requireNoGlass("inside", inside);
    }

    private static void requireNoGlass(String property, Surface surface) {
        Require.present(property, surface);
        if (surface.parts().anyMatch(Refractive.class::isInstance)) {
            throw new InvalidPropertyException(
                    property, "without Refractive in it, because a medium has two sides", "one with Refractive");
        }
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return at(ray, hit).respond(ray, hit, tracer);
    }

    private Surface at(Ray ray, Hit hit) {
        return hit.cosine(ray) < 0 ? outside : inside;
    }

    @Override
    public boolean usesCoordinates() {
        return outside.usesCoordinates() || inside.usesCoordinates();
    }

    @Override
    public Shadow shadow() {
        return outside.shadow().orElsewhere(inside.shadow());
    }

    @Override
    public boolean throwsShadowAt(Ray ray, Hit hit) {
        return at(ray, hit).throwsShadowAt(ray, hit);
    }

    @Override
    public Stream<Surface> parts() {
        return Stream.of(outside, inside).flatMap(Surface::parts);
    }

    @Override
    public boolean showsTime() {
        return outside.showsTime() || inside.showsTime();
    }

    @Override
    public boolean continuesRays() {
        return outside.continuesRays() || inside.continuesRays();
    }
}
