package tompkins.experiment;

import tompkins.lesson.LessonNumber;

/**
 * What the measurement of a lesson's number gave.
 *
 * @param number what was to be measured
 * @param measured what was measured, in the unit of the number
 */
public record LessonResult(LessonNumber number, double measured) {

    /** How much more was measured than the formula says. */
    public double error() {
        return measured - number.value();
    }

    /** Whether the measured number is as near to the formula as the lesson says. */
    public boolean agrees() {
        return Math.abs(error()) <= number.tolerance();
    }
}
