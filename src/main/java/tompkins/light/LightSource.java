package tompkins.light;

import org.joml.Vector3dc;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A source of light, at rest in the frame that it lights. */
public sealed interface LightSource permits AmbientLight, PointLight {

    /** The light of this source that a surface sends back along a ray that hit it. */
    Colour reflected(Ray ray, Hit hit, Colour diffuse, Colour specular, Visibility visibility);

    /** The same source in a coordinate system whose origin lies at {@code origin} of this one. */
    LightSource seenFrom(Vector3dc origin);

    /** The place from which the light comes, or null if it has none. */
    default Vector3dc position() {
        return null;
    }
}
