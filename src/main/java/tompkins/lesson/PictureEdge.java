package tompkins.lesson;

import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;

/** The point of an edge on the straight line between two points of the picture. */
@Meaning(
        "The point just behind an edge on the straight way between two points of the picture; an edge is where another object"
                + " begins or the colour jumps")
public record PictureEdge(
        @Meaning("Where the way begins, as a fraction of the picture's width from the left, 0 to 1")
        double across,

        @Meaning("Where it begins, as a fraction of the height from the top, 0 to 1")
        double down,

        @Meaning("Where it ends, as a fraction of the width, 0 to 1")
        double toAcross,

        @Meaning("Where it ends, as a fraction of the height, 0 to 1")
        double toDown,

        @Meaning("Which edge on the way, counted from 1") int count)
        implements MeasuringPoint {

    /** The first edge from the left, at half the height. */
    public static final PictureEdge DEFAULT = new PictureEdge(0, 0.5, 1, 0.5, 1);

    private static final int MOST = 1000;

    /** Checks that the line lies in the picture. */
    public PictureEdge {
        Require.within("across", across, 0, 1);
        Require.within("down", down, 0, 1);
        Require.within("toAcross", toAcross, 0, 1);
        Require.within("toDown", toDown, 0, 1);
        if (across == toAcross && down == toDown) {
            throw new InvalidPropertyException("toAcross", "another point than the beginning", toAcross);
        }
        Require.within("count", count, 1, MOST);
    }
}
