package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** A measurement in a photograph that is taken on the ride of the scene. */
@Meaning("A measurement in a photograph that is taken on the `ride` of the scene")
public record OnRide(
        @Meaning(
                value = "When it is taken, by the clock on board since the ride began: from 0 to the end of its legs",
                unit = "time")
        double properTime,

        @Meaning("What is measured there") Measurement measurement)
        implements Measurement {

    /** The Doppler factor at the beginning. */
    public static final OnRide DEFAULT = new OnRide(0, RayReading.DEFAULT);

    /** Checks all values. Whether the ride takes so long cannot be checked here. */
    public OnRide {
        Require.duration("properTime", properTime);
    }
}
