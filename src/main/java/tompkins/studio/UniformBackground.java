package tompkins.studio;

import tompkins.property.Meaning;
import tompkins.ray.Colour;

/** The same colour everywhere. */
@Meaning("The same colour in all directions")
public record UniformBackground(@Meaning("The colour") Colour colour) implements Background {

    /** The blue of the paper's figures. */
    public static final UniformBackground DEFAULT = new UniformBackground(new Colour(0.5, 0.5, 1));

    /** Checks the colour. */
    public UniformBackground {
        Colour.required("colour", colour);
    }

    @Override
    public Colour colour(double dx, double dy, double dz, double angle) {
        return colour;
    }
}
