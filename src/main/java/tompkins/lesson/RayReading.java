package tompkins.lesson;

import tompkins.property.Meaning;

/** A reading of one ray. */
@Meaning("A reading of the ray at a point of the picture")
public record RayReading(
        @Meaning("Where in the picture") MeasuringPoint point,

        @Meaning(
                "What is read: the position or the time in the scene at which the light left what is seen; the time by its own"
                        + " clocks; the frequency seen divided by the frequency sent; or the brightness in linear light")
        RayValue value)
        implements Measurement {

    /** The Doppler factor in the middle of the picture. */
    public static final RayReading DEFAULT = new RayReading(PicturePoint.DEFAULT, RayValue.FREQUENCY_RATIO);
}
