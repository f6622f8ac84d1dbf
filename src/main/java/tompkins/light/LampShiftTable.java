package tompkins.light;

import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The bands of a black body where its light and the surfaces that it lights have two different shifts: the temperature
 * follows the way from the lamp to the camera, the edges of the bands only that from the surface. The row of a
 * temperature is worked out when it is first asked for, in about a millisecond; it does not depend on who asks.
 */
final class LampShiftTable {

    /** Logarithms of the edge factors between which an edge lies in the visible. Outside, nothing changes any more. */
    private static final double LEAST_EDGE = -0.62;

    private static final double MOST_EDGE = 0.57;

    /** For each edge factor the three channels of what lies above the first edge, then of that above the second. */
    private static final int NUMBERS = 6;

    /** A fraction of a band that is nearer to 0 or 1 counts as 0 or 1. */
    private static final double NEGLIGIBLE = 1e-9;

    private final List<BlackBodyColours.SpectralPoint> spectrum;
    private final int stepsPerUnit;
    private final int edgeEntries;

    // for each edge factor and wavelength the fraction above the first edge, and above the second
    private final double[] aboveFirst;
    private final double[] aboveSecond;
    private final AtomicReferenceArray<double[]> rows;

    /**
     * An empty table.
     *
     * @param stepsPerUnit entries for each unit of the logarithm of an edge factor
     * @param temperatures number of temperatures
     */
    LampShiftTable(List<BlackBodyColours.SpectralPoint> spectrum, int stepsPerUnit, int temperatures) {
        this.spectrum = spectrum;
        this.stepsPerUnit = stepsPerUnit;
        edgeEntries = (int) ((MOST_EDGE - LEAST_EDGE) * stepsPerUnit) + 1;
        rows = new AtomicReferenceArray<>(temperatures);
        aboveFirst = new double[edgeEntries * spectrum.size()];
        aboveSecond = new double[edgeEntries * spectrum.size()];
        int index = 0;
        for (int entry = 0; entry < edgeEntries; entry++) {
            double edgeFactor = Math.exp(LEAST_EDGE + (double) entry / stepsPerUnit);
            for (BlackBodyColours.SpectralPoint point : spectrum) {
                double atSurface = edgeFactor * point.wavelength();
                aboveFirst[index] = BlackBodyColours.aboveFirst(atSurface);
                aboveSecond[index] = BlackBodyColours.aboveSecond(atSurface);
                index++;
            }
        }
    }

    /**
     * The screen's colours of the black body above the first edge and above the second.
     *
     * @param temperature number of the temperature
     * @param temperatureFactor that temperature, divided by that of white light
     * @param logEdgeFactor logarithm of the edge factor
     * @param first receives what lies above the first edge
     * @param second receives what lies above the second edge
     */
    void bands(int temperature, double temperatureFactor, double logEdgeFactor, Vector3d first, Vector3d second) {
        double[] row = rows.get(temperature);
        if (row == null) {
            row = row(temperatureFactor);
            rows.set(temperature, row);
        }
        double position = Math.max(0, Math.min(edgeEntries - 1, (logEdgeFactor - LEAST_EDGE) * stepsPerUnit));
        int before = NUMBERS * (int) Math.min(position, edgeEntries - 2);
        double fraction = position - before / NUMBERS;
        first.set(
                between(row, before, fraction), between(row, before + 1, fraction), between(row, before + 2, fraction));
        second.set(
                between(row, before + 3, fraction),
                between(row, before + 4, fraction),
                between(row, before + 5, fraction));
    }

    private static double between(double[] row, int before, double fraction) {
        return (1 - fraction) * row[before] + fraction * row[before + NUMBERS];
    }

    private double[] row(double temperatureFactor) {
        int points = spectrum.size();
        // the sums of all wavelengths from each on
        double[] red = new double[points + 1];
        double[] green = new double[points + 1];
        double[] blue = new double[points + 1];
        for (int i = points - 1; i >= 0; i--) {
            Vector3dc weight = spectrum.get(i).weight();
            double planck =
                    BlackBodyColours.planck(temperatureFactor, spectrum.get(i).wavelength());
            red[i] = red[i + 1] + planck * weight.x();
            green[i] = green[i + 1] + planck * weight.y();
            blue[i] = blue[i + 1] + planck * weight.z();
        }
        double[] row = new double[NUMBERS * edgeEntries];
        for (int entry = 0; entry < edgeEntries; entry++) {
            sum(red, green, blue, aboveFirst, entry * points, row, entry * NUMBERS);
            sum(red, green, blue, aboveSecond, entry * points, row, entry * NUMBERS + NUMBERS / 2);
        }
        return row;
    }

    /**
     * What lies above an edge: all from where its fraction is 1, and what the edge leaves of the wavelengths before.
     */
    private static void sum(
            double[] red, double[] green, double[] blue, double[] fractions, int from, double[] row, int index) {
        int whole = red.length - 1;
        while (whole > 0 && fractions[from + whole - 1] > 1 - NEGLIGIBLE) {
            whole--;
        }
        double sumRed = red[whole];
        double sumGreen = green[whole];
        double sumBlue = blue[whole];
        for (int i = whole - 1; i >= 0 && fractions[from + i] > NEGLIGIBLE; i--) {
            sumRed += (red[i] - red[i + 1]) * fractions[from + i];
            sumGreen += (green[i] - green[i + 1]) * fractions[from + i];
            sumBlue += (blue[i] - blue[i + 1]) * fractions[from + i];
        }
        row[index] = sumRed;
        row[index + 1] = sumGreen;
        row[index + 2] = sumBlue;
    }
}
