package tompkins.lesson;

import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;

/** The one number of the studio that a lesson lets its readers move. */
@Meaning("The one number of the scene that a lesson lets its readers move")
public record LessonControl(
        @Meaning(
                "The place of the number, as messages write it, such as `velocity.beta`, `camera.shutter.openingTime` or"
                        + " `scene[0].velocity.beta`")
        String number,

        @Meaning("What the slider is called, at most 40 letters")
        String name,

        @Meaning("The number at the left end of the slider") double from,

        @Meaning("The number at the right end of the slider")
        double to,

        @Meaning("The number with which everything is measured at the end")
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
        Require.coordinate("measuredAt", measuredAt);
    }
}
