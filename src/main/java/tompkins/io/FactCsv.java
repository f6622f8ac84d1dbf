package tompkins.io;

import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.measure.Fact;
import tompkins.measure.Quantity;
import tompkins.property.OneLine;

/**
 * Facts as tables with commas (RFC 4180) for other programs: numbers with 17 significant digits and a decimal point,
 * nothing where there is no number; units stand in the headings.
 */
public final class FactCsv {

    private FactCsv() {}

    /** A table: headings, and a row for each list of facts, which have the same keys and units. */
    public static Stream<String> table(List<Fact> headings, Stream<List<Fact>> rows) {
        return Stream.concat(
                Stream.of(joined(Fact.forPrograms(headings).map(FactCsv::heading))),
                rows.map(row -> joined(Fact.forPrograms(row).map(FactCsv::value))));
    }

    /** A table with a row for each fact. */
    public static Stream<String> quantities(List<Fact> facts) {
        return Stream.concat(
                Stream.of("quantity,value,uncertainty,unit"),
                Fact.forPrograms(facts)
                        .map(fact -> joined(Stream.of(
                                fact.key(),
                                value(fact),
                                fact instanceof Quantity quantity ? number(quantity.uncertainty()) : "",
                                fact instanceof Quantity quantity ? quantity.unit() : ""))));
    }

    private static String joined(Stream<String> cells) {
        return cells.map(FactCsv::cell).collect(Collectors.joining(","));
    }

    private static String heading(Fact fact) {
        return fact instanceof Quantity quantity && !quantity.unit().isEmpty()
                ? fact.key() + " [" + quantity.unit() + "]"
                : fact.key();
    }

    private static String value(Fact fact) {
        if (fact instanceof Quantity quantity) {
            return number(quantity.value());
        }
        if (fact instanceof Fact.Flag flag) {
            return Boolean.toString(flag.value());
        }
        return fact instanceof Fact.Word word && word.text() != null ? OneLine.of(word.text()) : "";
    }

    private static String number(double value) {
        return Objects.toString(FactJson.digits(value), "");
    }

    private static String cell(String text) {
        boolean plain = text.chars().noneMatch(letter -> letter == ',' || letter == '"');
        return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
    }
}
