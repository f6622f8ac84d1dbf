package tompkins.surface;

import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Two surfaces, one on either side. Glass is refused, because a medium has two sides of its own. */
@Meaning("One surface on the outside of an object, another one on its inside; on flat pieces the outside is the front")
public record TwoSided(
        @Meaning("What it looks like from outside") Surface outside,

        @Meaning("What it looks like from inside") Surface inside)
        implements CompositeSurface {

    /** White outside, dark grey inside. */
    public static final TwoSided DEFAULT = new TwoSided(
            new ColouredSurface(Colour.WHITE, Colour.BLACK), new ColouredSurface(Colour.grey(0.2), Colour.BLACK));

    /** Checks both surfaces. */
    public TwoSided {
        requireNoGlass("outside", outside);
        requireNoGlass("inside", inside);
    }

    private static void requireNoGlass(String property, Surface surface) {
        if (surface.parts().anyMatch(Refractive.class::isInstance)) {
            throw new InvalidPropertyException(
                    property, "without Refractive in it, because a medium has two sides", "one with Refractive");
        }
    }

    @Override
    public Surface first() {
        return outside;
    }

    @Override
    public Surface second() {
        return inside;
    }

    @Override
    public double fractionOfSecond(Ray ray, Hit hit) {
        return hit.cosine(ray) < 0 ? 0 : 1;
    }
}
