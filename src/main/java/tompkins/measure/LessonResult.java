package tompkins.measure;

import java.util.List;
import tompkins.lesson.LessonNumber;
import tompkins.property.NumberText;

/**
 * The result of measuring a number of a lesson.
 *
 * @param number what was to be measured
 * @param measured what was measured, in the unit of the number
 * @param sketch where that was, in pixels of the picture
 */
public record LessonResult(LessonNumber number, double measured, Sketch sketch) {

    /** By how much the measured value is above that of the formula. */
    public double error() {
        return measured - number.value();
    }

    /** What is told about it, as a row of a table. */
    public List<Fact> facts() {
        String unit = number.unit().isEmpty() ? "" : " " + number.unit();
        return List.of(
                new Fact.Word("name", "number", number.name()),
                new Fact.Word("formula", "formula", number.formula()),
                Quantity.exact("value", "", number.unit(), number.value()),
                Quantity.exact("measured", "", number.unit(), measured),
                new Fact.Word("", "value", predictedText() + unit),
                new Fact.Word("", "measured", measuredText() + unit),
                Quantity.exact("tolerance", "allowed difference", "", number.tolerance()),
                new Fact.Flag("agrees", "agrees", agrees()),
                new Fact.Word("unit", "", number.unit()));
    }

    /** What the formula gives, with no more digits than the tolerance has. */
    public String predictedText() {
        return new Quantity("", "", number.unit(), number.value(), number.tolerance()).briefText();
    }

    /** What was measured: what is counted in full, else to the second digit of the tolerance. */
    public String measuredText() {
        return Math.rint(measured) == measured
                ? NumberText.of(measured)
                : new Quantity("", "", "", measured, number.tolerance()).text(0);
    }

    /** Whether the measured number is as near to the formula as the lesson says. */
    public boolean agrees() {
        return Math.abs(error()) <= number.tolerance();
    }
}
