package tompkins.ui.panel;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import tompkins.measure.ConicFit;
import tompkins.measure.Measured;
import tompkins.measure.Quantity;
import tompkins.measure.SizeRatios;
import tompkins.property.NumberText;
import tompkins.ui.widget.Texts;

/** Says in a few lines what was measured; a table has all of it, with all digits and units. */
final class MeasureWords {

    private static final int DIGITS = 5;
    private static final String GAP = " \u00b7 ";

    /** Components of a direction, and places of what is drawn in the picture. */
    private static final Pattern IN_TABLE = Pattern.compile("(middle|normal)[XYZ]|centrePixel[XY]");

    private static final Pattern PLACE = Pattern.compile(".*Pixel[XY]");

    /** The size of a parabola; others have axes. */
    private static final String WIDTH = "semiLatusRectum";

    /** What is written behind a number; lengths and times are in the units of the scene, as everywhere. */
    private static final Map<String, String> UNITS =
            Map.of("degrees", "\u00b0", "arc minutes", "\u00a0arc\u00a0minutes", "pixels", "\u00a0pixels");

    private MeasureWords() {}

    /** All that was measured in a picture. */
    static String of(Measured measured) {
        return measured.quantities().isEmpty()
                ? Texts.get("measure.noEdge")
                : joined(measured, measured.quantities(), MeasureWords::words);
    }

    /** The sizes in another picture, each with how many times as large it is in this one. */
    static String compared(Measured other, Measured measured) {
        Map<String, Quantity> ratios =
                SizeRatios.of(measured, other).stream().collect(Collectors.toMap(Quantity::key, Function.identity()));
        List<Quantity> sizes = other.quantities().stream()
                .filter(size -> ratios.containsKey(size.key()))
                .toList();
        return sizes.isEmpty()
                ? of(other)
                : joined(
                        other,
                        sizes,
                        size -> words(size) + " " + Texts.get("measure.ratio", number(ratios.get(size.key()))));
    }

    private static String joined(Measured measured, List<Quantity> quantities, Function<Quantity, String> words) {
        String shape = measured.shape() == null ? "" : Texts.get("measure.shape." + measured.shape()) + " ";
        return shape
                + quantities.stream()
                        .filter(quantity -> isTold(measured, quantity.key()))
                        .map(words)
                        .collect(Collectors.joining(GAP));
    }

    private static boolean isTold(Measured measured, String key) {
        return !IN_TABLE.matcher(key).matches() && (measured.shape() == ConicFit.Kind.PARABOLA || !key.equals(WIDTH));
    }

    private static String words(Quantity quantity) {
        // columns and rows are numbers, not lengths
        String unit = PLACE.matcher(quantity.key()).matches() ? "" : UNITS.getOrDefault(quantity.unit(), "");
        return Texts.get("measure." + quantity.key()) + "\u00a0" + number(quantity) + unit;
    }

    private static String number(Quantity quantity) {
        String value = Double.isFinite(quantity.value()) ? NumberText.of(quantity.rounded(DIGITS)) : "\u2013";
        return Double.isFinite(quantity.uncertainty())
                ? value + " \u00b1 " + NumberText.of(NumberText.rounded(quantity.uncertainty(), 2))
                : value;
    }
}
