package tompkins.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.GoldenRow;
import tompkins.ray.Colour;

class ColourLawTest {

    @Test
    void colourIsWhatItIsWithoutDopplerShift() {
        Random random = new Random(1);
        for (ColourLaw law : ColourLaw.values()) {
            for (int i = 0; i < 100; i++) {
                Colour light = new Colour(random.nextDouble(), random.nextDouble(), random.nextDouble());
                assertSame(law.seen(light, 1), light, 1e-12);
            }
            assertThat(law.brightness(1)).isCloseTo(1, within(1e-12));
        }
    }

    /**
     * Summed over the wavelength in steps of 0.1 nm, with the CIE 1931 functions by cubic interpolation: the planck
     * factor for 6504 K times both factors, the edges of the bands at 494 and 590 nm divided by the second one.
     */
    @ParameterizedTest
    @CsvSource({
        "0.3, 0.6, 0.2, 1, 1.2, 0.55241, 0.58003, 1.37765",
        "0.3, 0.6, 0.2, 1.5, 1, 0.95293, 2.46303, 1.13326",
        "0.3, 0.6, 0.2, 0.7, 1.2, 0.15346, 0.13523, 0.23091",
        "1, 0, 0, 1.25, 0.8, 0.01527, 0.01840, 0.01820",
        "0.1, 0.2, 0.9, 2, 0.6, 1.54619, 1.69770, 1.97555",
        "0.9, 0.4, 0.1, 0.5, 1.6, 0.36706, 0.31744, 0.25117",
        "0, 1, 0, 3, 1.1, 0, 12.87713, 20.77852",
        "0.2, 0.5, 1, 0.8, 0.9, 0.09160, 0.15881, 0.14228"
    })
    void lightOfAMovingLampHasTwoShifts(
            double red, double green, double blue, double lamp, double camera, double r, double g, double b) {
        Colour seen = ColourLaw.DOPPLER.seen(new Colour(red, green, blue), lamp, camera);

        assertSame(seen, new Colour(r, g, b), 2e-5 + 2e-4 * Math.max(r, Math.max(g, b)));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 2", "2, 0.5", "3, 1.4", "0.1, 0.9", "400, 50", "1e-5, 1", "30, 1e-3"})
    void whiteLightOnWhiteHasTheShiftOfTheWholeWay(double lamp, double camera) {
        Colour whole = ColourLaw.DOPPLER.seen(Colour.WHITE, lamp * camera);

        assertSame(
                ColourLaw.DOPPLER.seen(Colour.WHITE, lamp, camera), whole, 1e-12 * Math.max(whole.red(), whole.blue()));
    }

    @Test
    void secondShiftDoesNotUndoTheFirst() {
        Colour once = ColourLaw.DOPPLER.seen(Colour.WHITE, 0.5);

        assertThat(ColourLaw.DOPPLER.seen(once, 2).red()).isNotCloseTo(1, within(0.05));
        assertSame(ColourLaw.DOPPLER.seen(Colour.WHITE, 0.5, 2), Colour.WHITE, 1e-12);
    }

    @Test
    void lampAtRestChangesNoBit() {
        Colour light = new Colour(0.3, 0.6, 0.2);
        for (double factor : new double[] {0.01, 0.7, 1, 1.3, 30}) {
            Colour seen = ColourLaw.DOPPLER.seen(light, factor);
            assertThat(ColourLaw.DOPPLER.seen(light, 1, factor)).isEqualTo(seen);
            assertSame(
                    ColourLaw.DOPPLER.seen(light, 1 + 1e-12, factor), seen, 1e-5 * Math.max(seen.red(), seen.blue()));
        }
    }

    @Test
    void unchangedLightStays() {
        Colour light = new Colour(0.1, 0.2, 3);
        assertThat(ColourLaw.UNCHANGED.seen(light, 7)).isEqualTo(light);
        assertThat(ColourLaw.UNCHANGED.brightness(7)).isEqualTo(1);
        assertThat(ColourLaw.UNCHANGED.ofBlackBody(4000, 7).luminance()).isCloseTo(1, within(1e-3));
    }

    @ParameterizedTest
    @CsvSource({"2, 16", "0.5, 0.0625", "1000, 1e12"})
    void searchlightGrowsByTheFourthPower(double dopplerFactor, double factor) {
        assertSame(
                ColourLaw.SEARCHLIGHT.seen(new Colour(0.1, 0.2, 3), dopplerFactor),
                new Colour(0.1 * factor, 0.2 * factor, 3 * factor),
                1e-12 * factor);
        assertThat(ColourLaw.SEARCHLIGHT.brightness(dopplerFactor)).isCloseTo(factor, within(1e-12 * factor));
        assertSame(
                ColourLaw.SEARCHLIGHT.ofBlackBody(4000, dopplerFactor),
                ColourLaw.UNCHANGED.ofBlackBody(4000, dopplerFactor).times(factor),
                1e-12 * factor);
    }

    @Test
    void coloursAreThoseOfTheReference() {
        List<GoldenRow> rows = GoldenColours.rows(0.2, 1000);
        assertThat(rows).hasSizeGreaterThan(50);
        assertThat(GoldenColours.worstWhite(rows)).isLessThan(3e-4);
        assertThat(GoldenColours.worstPrimary(rows)).isLessThan(2e-3);
    }

    /** The sums of the table of CIE 15 in steps of 5 nm. */
    @Test
    void matchingFunctionsHaveTheirSums() {
        Vector3d sum = new Vector3d();
        List<double[]> table = ResourceTable.lines("cie-1931.csv").stream()
                .map(cells -> Stream.of(cells).mapToDouble(Double::parseDouble).toArray())
                .toList();
        table.stream()
                .filter(point -> point[0] % 5 == 0 && point[0] >= 380 && point[0] <= 780)
                .forEach(point -> sum.add(point[1], point[2], point[3]));
        assertThat(sum.x).isCloseTo(21.371524, within(2e-6));
        assertThat(sum.y).isCloseTo(21.371327, within(2e-6));
        assertThat(sum.z).isCloseTo(21.371540, within(2e-6));
        assertThat(table).hasSize(471);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 5e-9, 1e-3, 0.0301, 0.0302, 0.1, 8103, 8104, 2e8})
    void allShiftsGiveLight(double dopplerFactor) {
        Colour seen = ColourLaw.DOPPLER.seen(new Colour(0.3, 0.6, 0.2), dopplerFactor);
        Colour more = ColourLaw.DOPPLER.seen(new Colour(0.3, 0.6, 0.2), dopplerFactor * 1.001 + 1e-12);
        assertThat(seen.isFinite()).isTrue();
        assertThat(seen.red()).isBetween(0.0, more.red());
        assertThat(seen.green()).isBetween(0.0, more.green());
        assertThat(seen.blue()).isBetween(0.0, more.blue());
        assertThat(more.red()).isLessThan(seen.red() * 1.2 + 1e-40);
    }

    private static void assertSame(Colour colour, Colour expected, double tolerance) {
        assertThat(colour.red()).isCloseTo(expected.red(), within(tolerance));
        assertThat(colour.green()).isCloseTo(expected.green(), within(tolerance));
        assertThat(colour.blue()).isCloseTo(expected.blue(), within(tolerance));
    }
}
