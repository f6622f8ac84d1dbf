package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** The angular radius of the circle of directions that fits an outline best; that of a sphere is one in every frame. */
@Meaning(
        "The angular radius, in degrees, of the circle that fits an outline best; the outline is where the first edge is met"
                + " on the way outwards from a point, in many directions")
public record CircleRadius(
        @Meaning("A point inside the outline, as a fraction of the picture's width from the left, 0 to 1")
        double across,

        @Meaning("The same point, as a fraction of the height from the top, 0 to 1")
        double down)
        implements Measurement {

    /** Around the middle of the picture. */
    public static final CircleRadius DEFAULT = new CircleRadius(0.5, 0.5);

    /** Checks that the point lies in the picture. */
    public CircleRadius {
        Require.within("across", across, 0, 1);
        Require.within("down", down, 0, 1);
    }
}
