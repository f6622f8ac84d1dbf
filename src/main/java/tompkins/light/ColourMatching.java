package tompkins.light;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * What the eye makes of light of one wavelength: the colour-matching functions of the CIE 1931 standard observer, from
 * 360 to 830 nm in steps of 1 nm.
 *
 * @param wavelength in nanometres
 * @param xyz the values of the three functions there
 */
record ColourMatching(int wavelength, Vector3dc xyz) {

    /** G. Wyszecki, W. S. Stiles, Color Science, 2nd edition (1982), table I(3.3.1). */
    private static final String FILE = "cie-1931.csv";

    /** The whole table, from short wavelengths to long ones. */
    static List<ColourMatching> table() {
        try (InputStream file = ColourMatching.class.getResourceAsStream(FILE);
                BufferedReader reader = new BufferedReader(new InputStreamReader(file, StandardCharsets.UTF_8))) {
            return reader.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(ColourMatching::of)
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static ColourMatching of(String line) {
        String[] cells = line.split(",");
        double[] values = Stream.of(cells).mapToDouble(Double::parseDouble).toArray();
        return new ColourMatching(Integer.parseInt(cells[0]), new Vector3d(values[1], values[2], values[3]));
    }
}
