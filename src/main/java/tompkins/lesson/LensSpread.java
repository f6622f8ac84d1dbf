package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** How sharp a shutter is: the blur of what is in focus. */
@Meaning("The blur, in pixels, of what is in focus at a point: how far apart the places look that rays from all round"
        + " the rim of the lens pass; 0 is sharp")
public record LensSpread(
        @Meaning("Where in the picture, as a fraction of its width from the left, 0 to 1")
        double across,

        @Meaning("Where, as a fraction of its height from the top, 0 to 1")
        double down)
        implements Measurement {

    /** In the middle of the picture. */
    public static final LensSpread DEFAULT = new LensSpread(0.5, 0.5);

    /** Checks that the point lies in the picture. */
    public LensSpread {
        Require.within("across", across, 0, 1);
        Require.within("down", down, 0, 1);
    }
}
