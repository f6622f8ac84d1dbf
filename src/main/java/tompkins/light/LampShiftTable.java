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
        double[] row = new double[NUMBERS * edgeEntries];
        for (int i = 0; i < spectrum.size(); i++) {
            Vector3dc weight = spectrum.get(i).weight();
            double planck =
                    BlackBodyColours.planck(temperatureFactor, spectrum.get(i).wavelength());
            for (int entry = 0; entry < edgeEntries; entry++) {
                int at = entry * spectrum.size() + i;
                for (int channel = 0; channel < 3; channel++) {
                    row[NUMBERS * entry + channel] += planck * weight.get(channel) * aboveFirst[at];
                    row[NUMBERS * entry + 3 + channel] += planck * weight.get(channel) * aboveSecond[at];
                }
            }
        }
        return row;
    }
}
