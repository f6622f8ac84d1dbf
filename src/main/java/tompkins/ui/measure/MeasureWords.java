package tompkins.ui.measure;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import tompkins.io.FactText;
import tompkins.measure.Fact;
import tompkins.measure.Measured;
import tompkins.measure.Quantity;
import tompkins.ui.widget.Texts;

/** Says in a few lines what was measured; a table has all of it, with all digits and units. */
final class MeasureWords {

    private static final String GAP = " \u00b7 ";

    private MeasureWords() {}

    /** All that was measured in a picture. */
    static String of(Measured measured) {
        return measured.facts().isEmpty()
                ? Texts.get("measure.noEdge")
                : Fact.forPeople(measured.facts()).map(MeasureWords::words).collect(Collectors.joining(GAP));
    }

    /** The sizes in another picture, each with how many times as large it is in this one. */
    static String compared(Measured other, Measured measured) {
        Map<String, Quantity> ratios = measured.ratiosTo(other);
        List<String> sizes = other.quantities()
                .filter(size -> ratios.containsKey(size.key()))
                .map(size ->
                        words(size) + " " + Texts.get("measure.ratio", FactText.SIGNS.number(ratios.get(size.key()))))
                .toList();
        return sizes.isEmpty() ? of(other) : String.join(GAP, sizes);
    }

    private static String words(Fact fact) {
        return FactText.SIGNS.name(fact) + "\u00a0" + FactText.SIGNS.value(fact);
    }
}
