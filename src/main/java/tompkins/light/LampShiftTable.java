package tompkins.light;

import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.DoubleUnaryOperator;
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

    private static final List<BlackBodyColours.SpectralPoint> SPECTRUM = BlackBodyColours.SPECTRUM;
    private static final int EDGES = (int) ((MOST_EDGE - LEAST_EDGE) * BlackBodyColours.STEPS_PER_UNIT) + 1;

    // for each edge factor and wavelength
    private static final double[] ABOVE_FIRST = fractions(BlackBodyColours::aboveFirst);
    private static final double[] ABOVE_SECOND = fractions(BlackBodyColours::aboveSecond);

    private static final AtomicReferenceArray<double[]> ROWS = new AtomicReferenceArray<>(BlackBodyColours.ENTRIES);

    private LampShiftTable() {}

    /** The fraction of each wavelength of the surface that lies above an edge. */
    private static double[] fractions(DoubleUnaryOperator above) {
        double[] fractions = new double[EDGES * SPECTRUM.size()];
        int index = 0;
        for (int entry = 0; entry < EDGES; entry++) {
            double edgeFactor = Math.exp(LEAST_EDGE + (double) entry / BlackBodyColours.STEPS_PER_UNIT);
            for (BlackBodyColours.SpectralPoint point : SPECTRUM) {
                fractions[index++] = above.applyAsDouble(edgeFactor * point.wavelength());
            }
        }
        return fractions;
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
    static void bands(
            int temperature, double temperatureFactor, double logEdgeFactor, Vector3d first, Vector3d second) {
        double[] row = ROWS.get(temperature);
        if (row == null) {
            row = row(temperatureFactor);
            ROWS.set(temperature, row);
        }
        double position =
                Math.max(0, Math.min(EDGES - 1, (logEdgeFactor - LEAST_EDGE) * BlackBodyColours.STEPS_PER_UNIT));
        int before = NUMBERS * (int) Math.min(position, EDGES - 2);
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

    private static double[] row(double temperatureFactor) {
        double[] row = new double[NUMBERS * EDGES];
        for (int i = 0; i < SPECTRUM.size(); i++) {
            Vector3dc weight = SPECTRUM.get(i).weight();
            double planck =
                    BlackBodyColours.planck(temperatureFactor, SPECTRUM.get(i).wavelength());
            for (int entry = 0; entry < EDGES; entry++) {
                int at = entry * SPECTRUM.size() + i;
                for (int channel = 0; channel < 3; channel++) {
                    row[NUMBERS * entry + channel] += planck * weight.get(channel) * ABOVE_FIRST[at];
                    row[NUMBERS * entry + 3 + channel] += planck * weight.get(channel) * ABOVE_SECOND[at];
                }
            }
        }
        return row;
    }
}
