package tompkins.light;

import java.util.List;
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
        return ResourceTable.lines(FILE).stream().map(ColourMatching::of).toList();
    }

    private static ColourMatching of(String[] cells) {
        return new ColourMatching(
                Integer.parseInt(cells[0]),
                new Vector3d(Double.parseDouble(cells[1]), Double.parseDouble(cells[2]), Double.parseDouble(cells[3])));
    }
}
