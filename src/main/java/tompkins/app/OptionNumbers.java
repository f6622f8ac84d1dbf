package tompkins.app;

import java.util.Arrays;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;

/** Numbers that an option takes together, with commas between them. */
final class OptionNumbers {

    private OptionNumbers() {}

    /** Finite numbers, as many as an example has. */
    static double[] of(String option, String text, String example) {
        String[] parts = text.split(",", -1);
        try {
            double[] numbers =
                    Arrays.stream(parts).mapToDouble(NumberText::parse).toArray();
            if (numbers.length == example.split(",").length
                    && Arrays.stream(numbers).allMatch(Double::isFinite)) {
                return numbers;
            }
        } catch (NumberFormatException notANumber) {
            // the message below says what is allowed
        }
        throw new MistakeException(option + " must be numbers with commas between them, such as " + option + "="
                + example + ", was " + text);
    }
}
