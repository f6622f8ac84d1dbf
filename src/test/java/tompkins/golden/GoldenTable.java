package tompkins.golden;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** The reference data: numbers that were worked out with 80 digits by another program (see the README beside them). */
public final class GoldenTable {

    /** Relative rounding error of one operation, 2^-53. */
    public static final double U = 0x1p-53;

    private GoldenTable() {}

    /** All rows of a file. */
    public static List<GoldenRow> rows(String name) {
        try (InputStream stream = GoldenTable.class.getResourceAsStream("/golden/" + name + ".csv");
                BufferedReader reader = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
            String[] columns = reader.readLine().split(",", -1);
            return reader.lines().map(line -> row(columns, line.split(",", -1))).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The rows of a file that fulfil a condition; there is at least one. */
    public static List<GoldenRow> rows(String name, Predicate<GoldenRow> condition) {
        List<GoldenRow> rows = rows(name).stream().filter(condition).toList();
        if (rows.isEmpty()) {
            throw new IllegalArgumentException(name + " has no such row");
        }
        return rows;
    }

    private static GoldenRow row(String[] columns, String[] cells) {
        if (columns.length != cells.length) {
            throw new IllegalArgumentException(cells[0] + " has " + cells.length + " cells, not " + columns.length);
        }
        Map<String, String> row = new HashMap<>();
        for (int i = 0; i < columns.length; i++) {
            row.put(columns[i], cells[i]);
        }
        return new GoldenRow(row);
    }
}
