package tompkins.light;

import java.util.stream.Stream;
import org.joml.Vector3dc;
import tompkins.ray.Colour;

/** A source of light at rest in its frame. */
public sealed interface RestingLight extends LightSource permits AmbientLight, PointLight {

    /** Colour and brightness of the light on dull surfaces. */
    Colour colour();

    /** Colour and brightness of the highlights on shiny surfaces. */
    default Colour highlightColour() {
        return Colour.BLACK;
    }

    /** How small the highlights are: the power of the cosine. */
    default double highlightExponent() {
        return 1;
    }

    @Override
    default Stream<RestingLight> atRest() {
        return Stream.of(this);
    }

    /** The same source elsewhere: farther by a vector. */
    RestingLight shifted(Vector3dc by);

    /** When it shines, by its own time. */
    default Flash flash() {
        return AlwaysOn.DEFAULT;
    }

    /** The place from which the light comes, or null if it has none. */
    default Vector3dc position() {
        return null;
    }
}
