package tompkins.surface;

import tompkins.ray.Colour;
import tompkins.ray.Ray;

/**
 * What a surface makes of a ray: light of its own, and at most one ray that goes on, which the tracer follows in a
 * loop. A surface that splits a ray asks the tracer for the colour of the weaker part.
 *
 * @param light what the surface sends back by itself
 * @param factor what becomes of the light of the ray that goes on
 * @param next the ray that goes on, or null
 */
public record Response(Colour light, Colour factor, Ray next) {

    /** Light of the surface alone. */
    public static Response ends(Colour light) {
        return new Response(light, Colour.BLACK, null);
    }

    /** Only the light of the ray that goes on, multiplied by a factor. */
    public static Response goesOn(Ray next, Colour factor) {
        return new Response(Colour.BLACK, factor, next);
    }

    /** This response multiplied by a factor. */
    Response times(double fraction) {
        return new Response(light.times(fraction), factor.times(fraction), next);
    }

    /** Both responses: the ray of this one goes on, that of the other, weaker one is followed to its end. */
    Response plus(Response weaker, Tracer tracer) {
        if (next == null) {
            return new Response(light.plus(weaker.light), weaker.factor, weaker.next);
        }
        Colour followed = weaker.next == null
                ? weaker.light
                : weaker.light.plus(tracer.colour(weaker.next).times(weaker.factor));
        return new Response(light.plus(followed), factor, next);
    }
}
