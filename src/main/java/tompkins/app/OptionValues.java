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
        commandLine.registerConverter(WorkPart.class, WorkPart::parse);
        commandLine.registerConverter(PictureFormat.class, OptionValues::format);
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
                throw refused("at most " + NumberText.of(Double.MAX_VALUE), text);
            }
            if (NumberText.vanishes(text)) {
                throw refused(NumberText.NOT_VANISHING, text);
            }
            return number;
        } catch (NumberFormatException word) {
            throw refused("a number", text);
        }
    }

    private static long wholeNumber(String text) {
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException notWhole) {
            throw refused("a whole number of at most 18 digits", text);
        }
    }

    private static PictureFormat format(String text) {
        return Stream.of(PictureFormat.values())
                .filter(format -> format.name().equalsIgnoreCase(text))
                .findFirst()
                .orElseThrow(() -> refused(
                        "one of "
                                + Stream.of(PictureFormat.values())
                                        .map(format -> format.name().toLowerCase(Locale.ROOT))
                                        .collect(Collectors.joining(", ")),
                        text));
    }

    /** The refusal of a word; the name of its option stands before it. */
    static TypeConversionException refused(String allowed, String word) {
        return new TypeConversionException("must be " + allowed + ", was " + shown(word));
    }
}
