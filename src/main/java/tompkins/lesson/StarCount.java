package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** How many stars of a sky are seen near the direction in which the camera moves. */
@Meaning("How many stars of a StarSky are seen near the direction of the camera's motion, in the picture or beside it")
public record StarCount(
        @Meaning(value = "The largest angle from the direction of motion, as seen, 0 to 180", unit = "degrees")
        double withinDegrees)
        implements Measurement {

    /** Those of the half of the sky that is ahead. */
    public static final StarCount DEFAULT = new StarCount(90);

    /** Checks the angle. */
    public StarCount {
        Require.within("withinDegrees", withinDegrees, 0, 180);
    }
}
