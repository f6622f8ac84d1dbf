package tompkins.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.light.BlackBodyColours.SpectralPoint;

/** A table of few wavelengths, against the sums that it stands for. */
class LampShiftTableTest {

    private static final int STEPS_PER_UNIT = 100;

    /** The edges of the bands and their softness, in nanometres; docs/conventions.md. */
    private static final double[] EDGES = {494, 590};

    private static final double SOFTNESS = 2;

    private static final List<SpectralPoint> SPECTRUM = List.of(
            new SpectralPoint(400, new Vector3d(0.1, -0.2, 0.9)),
            new SpectralPoint(493, new Vector3d(-0.3, 0.5, 0.6)),
            new SpectralPoint(497, new Vector3d(-0.4, 0.6, 0.5)),
            new SpectralPoint(560, new Vector3d(0.7, 0.8, -0.1)),
            new SpectralPoint(592, new Vector3d(0.9, 0.3, 0.05)),
            new SpectralPoint(700, new Vector3d(0.4, 0.01, 0.02)));

    private final LampShiftTable table = new LampShiftTable(SPECTRUM, STEPS_PER_UNIT, 2);

    @Test
    void anEntryIsTheSumOverTheWavelengths() {
        // the edges lie far below the wavelengths, among them, at one of them, and above
        for (double logEdge : new double[] {-0.62, -0.3, -0.1, -0.01, 0, 0.03, 0.1, 0.2, 0.39, 0.57}) {
            assertEntry(0, 1, logEdge);
            assertEntry(1, 0.4, logEdge);
            assertEntry(0, 1, logEdge);
        }
    }

    @Test
    void betweenTwoEntriesItIsInterpolated() {
        Vector3d expected = sum(0, 1, 0.03).lerp(sum(0, 1, 0.04), 0.25);
        assertClose(bands(0, 1, 0.0325)[0], expected);
    }

    @Test
    void beyondItsEndsNothingChanges() {
        assertClose(bands(0, 1, -5)[1], sum(1, 1, -5));
        assertClose(bands(0, 1, 5)[1], sum(1, 1, 5));
    }

    private void assertEntry(int temperature, double factor, double logEdge) {
        Vector3d[] bands = bands(temperature, factor, logEdge);
        assertClose(bands[0], sum(0, factor, logEdge));
        assertClose(bands[1], sum(1, factor, logEdge));
    }

    private static void assertClose(Vector3dc actual, Vector3dc expected) {
        assertThat(actual.distance(expected)).as("%s, not %s", actual, expected).isCloseTo(0, within(1e-9));
    }

    private Vector3d[] bands(int temperature, double factor, double logEdge) {
        Vector3d first = new Vector3d();
        Vector3d second = new Vector3d();
        table.bands(temperature, factor, logEdge, first, second);
        return new Vector3d[] {first, second};
    }

    /** What lies above an edge, of light of 6504 K times the factor. */
    private static Vector3d sum(int edge, double factor, double logEdge) {
        Vector3d sum = new Vector3d();
        for (SpectralPoint point : SPECTRUM) {
            double atSurface = Math.exp(logEdge) * point.wavelength();
            double share = 1 / (1 + Math.exp((EDGES[edge] - atSurface) / SOFTNESS));
            double planck = 1 / (Math.exp(1.438776877e7 / (6504 * factor * point.wavelength())) - 1);
            sum.fma(share * planck, point.weight());
        }
        return sum;
    }
}
