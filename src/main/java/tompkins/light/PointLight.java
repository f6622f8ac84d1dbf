package tompkins.light;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;

/** A small bright light that throws sharp shadows and highlights (Phong's model) and does not fade with distance. */
@Meaning("A small bright light that throws sharp shadows and highlights and does not fade with distance")
public record PointLight(
        @Meaning(value = "Where the light is", unit = "length")
        Vector3dc position,

        @Meaning("Colour and brightness of the light on dull surfaces")
        Colour colour,

        @Meaning("Colour and brightness of the highlights on shiny surfaces")
        Colour highlightColour,

        @Meaning("How small the highlights are: the power of the cosine")
        double highlightExponent,

        @Meaning("When the light shines") Flash flash)
        implements RestingLight {

    /** A white light behind, above and to the right of the camera. */
    public static final PointLight DEFAULT =
            new PointLight(new Vector3d(100, 300, -500), Colour.WHITE, Colour.WHITE, 40);

    /** In the frame of a moving camera, a lamp may be farther away than any place in a description. */
    private static final double FARTHEST = 1e100;

    /** Checks all values. */
    public PointLight {
        position = Require.position("position", position, FARTHEST);
        Colour.required("colour", colour);
        Colour.required("highlightColour", highlightColour);
        Require.notNegative("highlightExponent", highlightExponent);
        Require.present("flash", flash);
    }

    /** A light that shines all the time. */
    public PointLight(Vector3dc position, Colour colour, Colour highlightColour, double highlightExponent) {
        this(position, colour, highlightColour, highlightExponent, AlwaysOn.DEFAULT);
    }

    @Override
    public PointLight shifted(Vector3dc by) {
        return new PointLight(position.add(by, new Vector3d()), colour, highlightColour, highlightExponent, flash);
    }
}
