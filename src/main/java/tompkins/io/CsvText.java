package tompkins.io;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.measure.Measured;
import tompkins.measure.RayTable;
import tompkins.measure.Sighting;
import tompkins.property.OneLine;

/**
 * Tables as text with commas (RFC 4180) for other programs: numbers with 17 significant digits and a decimal point,
 * nothing where there is no number; units stand in the headings.
 */
public final class CsvText {

    private CsvText() {}

    /** The headings of a table of rays. */
    public static String rayHeadings() {
        return RayTable.COLUMNS.stream().map(column -> cell(column.heading())).collect(Collectors.joining(","));
    }

    /** The row of a ray. */
    public static String rayRow(Sighting sighting) {
        return RayTable.COLUMNS.stream()
                .map(column -> cell(column.value().apply(sighting)))
                .collect(Collectors.joining(","));
    }

    /** Measured numbers: a row for each, under headings; before them the shape of a conic. */
    public static Stream<String> quantities(Measured measured) {
        Stream<String> first = Stream.of("quantity,value,uncertainty,unit");
        return Stream.concat(
                measured.shape() == null ? first : Stream.concat(first, Stream.of("shape," + measured.shape() + ",,")),
                measured.quantities().stream()
                        .map(quantity -> cell(quantity.key()) + "," + cell(quantity.value()) + ","
                                + cell(quantity.uncertainty()) + "," + cell(quantity.unit())));
    }

    /** One cell: a number, a text in one line, or nothing for null and for what is not finite. */
    public static String cell(Object value) {
        if (value instanceof Double number) {
            return Double.isFinite(number) ? JsonText.digits(number) : "";
        }
        String text = value == null ? "" : OneLine.of(value.toString());
        boolean plain = text.chars().noneMatch(letter -> letter == ',' || letter == '"');
        return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
    }
}
