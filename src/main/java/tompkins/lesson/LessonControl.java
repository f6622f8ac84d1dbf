package tompkins.lesson;

import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;

/** The one number of the studio that a lesson lets its readers move. */
@Meaning("The one number of the scene that a lesson lets its readers move")
public record LessonControl(
        @Meaning(
                "The path of the number, as messages write it, such as `velocity.beta`, `camera.shutter.openingTime` or"
                        + " `scene[0].velocity.beta`")
        String number,

        @Meaning("What the slider is called, at most 40 letters")
        String name,

        @Meaning("The number at the left end of the slider") double from,

        @Meaning("The number at the right end of the slider")
        double to,

        @Meaning(
                "The number with which everything is measured at the end; from the left end of the slider to the right one")
        double measuredAt) {

    /** The speed of the camera. */
    public static final LessonControl DEFAULT = new LessonControl("velocity.beta", "Speed", 0, 0.9, 0.9);

    private static final int LONGEST_PATH = 100;
    private static final int LONGEST_NAME = 40;

    /** Checks all values. Whether the scene has such a number cannot be checked here. */
    public LessonControl {
        LessonText.required("number", number, LONGEST_PATH);
        LessonText.required("name", name, LONGEST_NAME);
        Require.coordinate("from", from);
        Require.coordinate("to", to);
        if (!(from < to)) {
            throw new InvalidPropertyException("to", "above from, which is " + NumberText.of(from), to);
        }
        requireReached("measuredAt", measuredAt, from, to);
    }

    /**
     * Checks that readers can set the slider to a value.
     *
     * @throws InvalidPropertyException if the value lies beyond its ends; the message names the property
     */
    public void requireReached(String property, double value) {
        requireReached(property, value, from, to);
    }

    private static void requireReached(String property, double value, double from, double to) {
        if (!(value >= from && value <= to)) {
            String ends = "from " + NumberText.of(from) + " to " + NumberText.of(to);
            throw new InvalidPropertyException(property, ends + ", where the slider of the lesson ends", value);
        }
    }
}
