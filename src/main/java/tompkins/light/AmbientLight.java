package tompkins.light;

import org.joml.Vector3dc;
import tompkins.property.Meaning;
import tompkins.ray.Colour;

/** Light that comes evenly from everywhere, without shadows. */
@Meaning("Light that comes evenly from everywhere, without shadows")
public record AmbientLight(
        @Meaning("Colour and brightness of the light") Colour colour) implements RestingLight {

    /** A dim white. */
    public static final AmbientLight DEFAULT = new AmbientLight(Colour.grey(0.2));

    /** Checks the colour. */
    public AmbientLight {
        Colour.required("colour", colour);
    }

    @Override
    public RestingLight shifted(Vector3dc by) {
        return this;
    }
}
