package tompkins.surface;

import tompkins.light.Illumination;
import tompkins.ray.Colour;
import tompkins.ray.Ray;

/** What a surface may ask of the tracer of its frame. */
public interface Tracer {

    /** The light that comes back along a ray, followed as far as it goes. */
    Colour colour(Ray ray);

    /** The light of the sources of the frame. */
    Illumination illumination();
}
