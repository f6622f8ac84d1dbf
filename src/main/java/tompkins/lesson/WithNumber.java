package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/**
 * A measurement in the picture of a scene in which one number has another value: a little later, or at another speed.
 */
@Meaning(
        "A measurement in another picture, in which one number of the scene has another value, such as the opening time")
public record WithNumber(
        @Meaning("The path of the number, as in the control of a lesson")
        String number,

        @Meaning("The number in that picture") double value,
        @Meaning("What is measured there") Measurement measurement)
        implements Measurement {

    /** One unit of time after the usual picture. */
    public static final WithNumber DEFAULT = new WithNumber("camera.shutter.openingTime", 1, RayReading.DEFAULT);

    private static final int LONGEST_PATH = 100;

    /** Checks all values. Whether the scene has such a number cannot be checked here. */
    public WithNumber {
        LessonText.required("number", number, LONGEST_PATH);
        Require.finite("value", value);
    }
}
