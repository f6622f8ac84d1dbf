package tompkins.app;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.TypeConversionException;
import tompkins.image.PictureFormat;
import tompkins.property.MistakeException;
import tompkins.property.NumberText;

/** What the words behind options mean. What is refused is told by what is allowed. */
final class OptionValues {

    private OptionValues() {}

    /** Lets a command line read values of all types that options have. */
    static void addTo(CommandLine commandLine) {
        commandLine.registerConverter(Path.class, NamedFile::of);
        commandLine.registerConverter(Double.class, OptionValues::number);
        commandLine.registerConverter(double.class, OptionValues::number);
        commandLine.registerConverter(Long.class, OptionValues::wholeNumber);
        commandLine.registerConverter(long.class, OptionValues::wholeNumber);
        commandLine.registerConverter(Part.class, Part::parse);
        commandLine.registerConverter(PictureFormat.class, text -> constant(PictureFormat.class, text));
    }

    /** Finite numbers with commas between them, as many as an example has. */
    static double[] numbers(String option, String text, String example) {
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
                + example + ", was " + shown(text));
    }

    /** A word as messages show it: an empty one would not be seen. */
    static String shown(String word) {
        return word.isEmpty() ? "\"\"" : word;
    }

    private static double number(String text) {
        try {
            double number = NumberText.parse(text);
            if (Double.isInfinite(number)) {
                throw new TypeConversionException("at most " + NumberText.of(Double.MAX_VALUE));
            }
            if (NumberText.vanishes(text)) {
                throw new TypeConversionException(NumberText.NOT_VANISHING);
            }
            return number;
        } catch (NumberFormatException word) {
            throw new TypeConversionException("a number");
        }
    }

    private static long wholeNumber(String text) {
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException refused) {
            boolean tooLong = text.matches("[+-]?[0-9]+");
            throw new TypeConversionException(tooLong ? "a whole number of at most 18 digits" : "a whole number");
        }
    }

    private static <E extends Enum<E>> E constant(Class<E> type, String text) {
        E[] constants = type.getEnumConstants();
        return Stream.of(constants)
                .filter(constant -> constant.name().equalsIgnoreCase(text))
                .findFirst()
                .orElseThrow(() -> new TypeConversionException((constants.length == 1 ? "" : "one of ")
                        + Stream.of(constants)
                                .map(constant -> constant.name().toLowerCase(Locale.ROOT))
                                .collect(Collectors.joining(", "))));
    }
}
