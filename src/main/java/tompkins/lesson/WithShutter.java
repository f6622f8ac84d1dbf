package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.Shutter;

/** A measurement in the picture that the camera takes with another shutter. */
@Meaning("A measurement in the picture that the camera takes with another shutter")
public record WithShutter(
        @Meaning("The other shutter") Shutter shutter,
        @Meaning("What is measured in that picture") Measurement measurement)
        implements Measurement {

    /** With a shutter at the lens. */
    public static final WithShutter DEFAULT = new WithShutter(AperturePlaneShutter.DEFAULT, RayReading.DEFAULT);
}
