package tompkins.surface;

import org.joml.Vector3dc;
import tompkins.light.Illumination;
import tompkins.ray.Colour;
import tompkins.ray.Medium;
import tompkins.ray.Ray;

/** What a surface may ask of the tracer of its frame. */
public interface Tracer {

    /** The light that comes back along a ray, followed as far as it goes. */
    Colour colour(Ray ray);

    /** The light of the sources of the frame. */
    Illumination illumination();

    /** Whether rays must know in which medium they are, because something moves. */
    default boolean keepsMedia() {
        return false;
    }

    /**
     * The proper velocity of the rest frame of a medium, where rays know theirs.
     *
     * @param frame the number of the frame in which it is wanted
     */
    default Vector3dc velocity(Medium medium, int frame) {
        throw new IllegalStateException("rays do not know their media");
    }
}
