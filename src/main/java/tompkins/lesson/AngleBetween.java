package tompkins.lesson;

import tompkins.property.Meaning;

/** The angle between the directions in which a camera sees two points of its picture. */
@Meaning("The angle between two points of the picture, as the camera sees it, in degrees")
public record AngleBetween(
        @Meaning("One point") MeasuringPoint first,
        @Meaning("The other point") MeasuringPoint second) implements Measurement {

    /** From the left edge of the picture to the right one. */
    public static final AngleBetween DEFAULT = new AngleBetween(new PicturePoint(0, 0.5), new PicturePoint(1, 0.5));
}
