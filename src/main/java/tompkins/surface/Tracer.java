package tompkins.surface;

import java.util.List;
import tompkins.light.LightSource;
import tompkins.light.Visibility;
import tompkins.ray.Colour;
import tompkins.ray.Ray;

/** What a surface may ask of the tracer of its frame. */
public interface Tracer extends Visibility {

    /** The light that comes back along a ray, followed as far as it goes. */
    Colour colour(Ray ray);

    /** The light sources of the frame. */
    List<LightSource> lights();
}
