package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** A point of the picture. */
@Meaning("A point of the picture")
public record PicturePoint(
        @Meaning("Fraction of the picture's width from the left, 0 to 1")
        double across,

        @Meaning("Fraction of its height from the top, 0 to 1")
        double down)
        implements MeasuringPoint {

    /** The middle of the picture. */
    public static final PicturePoint DEFAULT = new PicturePoint(0.5, 0.5);

    /** Checks that the point lies in the picture. */
    public PicturePoint {
        Require.within("across", across, 0, 1);
        Require.within("down", down, 0, 1);
    }
}
