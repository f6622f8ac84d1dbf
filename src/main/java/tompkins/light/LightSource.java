package tompkins.light;

import org.joml.Vector3dc;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A source of light: one at rest, or several that move. */
public sealed interface LightSource permits AmbientLight, PointLight, MovingLights {

    /** Adds the light of this source that a surface with the given colours sends back along a ray that hit it. */
    void reflect(Ray ray, Hit hit, Colour diffuse, Colour specular, Illumination sum);

    /** The same source in a coordinate system whose origin lies at {@code origin} of this one. */
    LightSource seenFrom(Vector3dc origin);

    /** When it shines, by its own time. */
    default Flash flash() {
        return AlwaysOn.DEFAULT;
    }

    /** The place from which the light comes, or null if it has none. */
    default Vector3dc position() {
        return null;
    }
}
