package tompkins.light;

import java.util.stream.Stream;
import org.joml.Vector3dc;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A source of light at rest in its frame. */
public sealed interface RestingLight extends LightSource permits AmbientLight, PointLight {

    /** Adds the light of this source that a surface with the given colours sends back along a ray that hit it. */
    void reflect(Ray ray, Hit hit, Colour diffuse, Colour specular, Illumination sum);

    @Override
    default Stream<RestingLight> atRest() {
        return Stream.of(this);
    }

    /** The same source in a coordinate system whose origin lies at {@code origin} of this one. */
    RestingLight seenFrom(Vector3dc origin);

    /** When it shines, by its own time. */
    default Flash flash() {
        return AlwaysOn.DEFAULT;
    }

    /** The place from which the light comes, or null if it has none. */
    default Vector3dc position() {
        return null;
    }
}
