package tompkins.experiment;

import tompkins.lesson.LessonNumber;

/**
 * The result of measuring a number of a lesson.
 *
 * @param number what was to be measured
 * @param measured what was measured, in the unit of the number
 */
public record LessonResult(LessonNumber number, double measured) {

    /** By how much the measured value is above that of the formula. */
    public double error() {
        return measured - number.value();
    }

    /** Whether the measured number is as near to the formula as the lesson says. */
    public boolean agrees() {
        return Math.abs(error()) <= number.tolerance();
    }
}
