package tompkins.light;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Tables that the program carries: lines of cells with commas between them, after comments that begin with #. */
final class ResourceTable {

    private ResourceTable() {}

    /** The lines of a file beside this class, cell by cell, without comments. */
    static List<String[]> lines(String file) {
        try (InputStream stream = ResourceTable.class.getResourceAsStream(file);
                BufferedReader reader = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
            return reader.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.split(","))
                    .toList();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
