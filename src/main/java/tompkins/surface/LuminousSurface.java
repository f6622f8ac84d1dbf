package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A surface that glows evenly by itself: neither lamps nor shadows change it. */
@Meaning("A surface that glows evenly by itself; light sources and shadows do not change it")
public record LuminousSurface(
        @Meaning("Colour of the glow") Colour colour,

        @Meaning("Whether it throws a shadow on other objects")
        boolean throwsShadow)
        implements Surface {

    /** White. */
    public static final LuminousSurface DEFAULT = new LuminousSurface(Colour.WHITE, true);

    /** Checks the colour. */
    public LuminousSurface {
        Colour.required("colour", colour);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return Response.ends(tracer.illumination().emitted(ray, colour));
    }

    @Override
    public Shadow shadow() {
        return throwsShadow ? Shadow.ALWAYS : Shadow.NEVER;
    }
}
