package tompkins.lesson;

import tompkins.property.Meaning;
import tompkins.property.Require;

/** A number that a lesson measures in its picture, and what a formula says about it. */
@Meaning("A number that is measured in the picture, and what a formula says")
public record LessonNumber(
        @Meaning("What is measured, at most 45 letters") String name,
        @Meaning("How it is measured") Measurement measurement,

        @Meaning("The formula in letters, at most 40 of them")
        String formula,

        @Meaning("What the formula gives") double value,

        @Meaning("How far the measured number may differ from it, above 0")
        double tolerance,

        @Meaning("Unit, such as `degrees`, at most 12 letters; may be empty")
        String unit) {

    /** The Doppler factor straight ahead at 0.9 c. */
    public static final LessonNumber DEFAULT = new LessonNumber(
            "Doppler factor straight ahead", RayReading.DEFAULT, "sqrt((1 + v)/(1 - v))", 4.3589, 0.001, "");

    private static final int LONGEST_NAME = 45;
    private static final int LONGEST_FORMULA = 40;
    private static final int LONGEST_UNIT = 12;

    /** Checks all values. */
    public LessonNumber {
        LessonText.required("name", name, LONGEST_NAME);
        LessonText.required("formula", formula, LONGEST_FORMULA);
        Require.finite("value", value);
        Require.positive("tolerance", tolerance);
        LessonText.optional("unit", unit, LONGEST_UNIT);
    }
}
