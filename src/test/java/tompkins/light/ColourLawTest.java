package tompkins.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.List;
import java.util.Random;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.golden.GoldenRow;
import tompkins.ray.Colour;

class ColourLawTest {

    private static final double WHITE_TEMPERATURE = 6504;

    /** XYZ of linear sRGB, IEC 61966-2-1, by rows. */
    private static final double[][] XYZ = {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}
    };

    /** The photopic luminosity function of 1924, from 380 to 750 nm in steps of 10 nm. */
    private static final double[] LUMINOSITY = {
        0.0000, 0.0001, 0.0004, 0.0012, 0.0040, 0.0116, 0.0230, 0.0380, 0.0600, 0.0910, 0.1390, 0.2080, 0.3230, 0.5030,
        0.7100, 0.8620, 0.9540, 0.9950, 0.9950, 0.9520, 0.8700, 0.7570, 0.6310, 0.5030, 0.3810, 0.2650, 0.1750, 0.1070,
        0.0610, 0.0320, 0.0170, 0.0082, 0.0041, 0.0021, 0.0010, 0.0005, 0.0002, 0.0001
    };

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
    void lightOfALampGrowsByTheFourthPowerOfBoth() {
        assertSame(
                ColourLaw.SEARCHLIGHT.seen(new Colour(0.1, 0.2, 3), 3, 0.5),
                new Colour(8.1 / 16, 16.2 / 16, 243.0 / 16),
                1e-12);
    }

    @Test
    void unchangedLightStays() {
        Colour light = new Colour(0.1, 0.2, 3);
        assertThat(ColourLaw.UNCHANGED.seen(light, 7)).isEqualTo(light);
        assertThat(ColourLaw.UNCHANGED.brightness(7)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({"2, 16", "0.5, 0.0625", "1000, 1e12"})
    void searchlightGrowsByTheFourthPower(double dopplerFactor, double factor) {
        assertSame(
                ColourLaw.SEARCHLIGHT.seen(new Colour(0.1, 0.2, 3), dopplerFactor),
                new Colour(0.1 * factor, 0.2 * factor, 3 * factor),
                1e-12 * factor);
        assertThat(ColourLaw.SEARCHLIGHT.brightness(dopplerFactor)).isCloseTo(factor, within(1e-12 * factor));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.1, 1.25, 1.5, 2, 2.5, 3, 3.8})
    void whiteBecomesABlackBodyOfAnotherTemperature(double dopplerFactor) {
        double[] seen = chromaticity(screenLight(ColourLaw.DOPPLER.seen(Colour.WHITE, dopplerFactor)));
        double[] locus = planckianLocus(WHITE_TEMPERATURE * dopplerFactor);
        assertThat(seen[0]).isCloseTo(locus[0], within(0.004));
        assertThat(seen[1]).isCloseTo(locus[1], within(0.004));
    }

    /** The channels of light that is balanced to a black body, as light on a screen whose white is another one. */
    private static Colour screenLight(Colour balanced) {
        double[] white = planckianLocus(WHITE_TEMPERATURE);
        Vector3d rgb = new Matrix3d(
                        XYZ[0][0], XYZ[1][0], XYZ[2][0], XYZ[0][1], XYZ[1][1], XYZ[2][1], XYZ[0][2], XYZ[1][2],
                        XYZ[2][2])
                .invert()
                .transform(new Vector3d(white[0] / white[1], 1, (1 - white[0] - white[1]) / white[1]));
        return balanced.times(new Colour(rgb.x, rgb.y, rgb.z));
    }

    private static double xyz(int row, Colour rgb) {
        return XYZ[row][0] * rgb.red() + XYZ[row][1] * rgb.green() + XYZ[row][2] * rgb.blue();
    }

    private static double[] chromaticity(Colour rgb) {
        double sum = xyz(0, rgb) + xyz(1, rgb) + xyz(2, rgb);
        return new double[] {xyz(0, rgb) / sum, xyz(1, rgb) / sum};
    }

    /** Chromaticity of black bodies from 1667 to 25000 K: cubic splines of Kim et al., US patent 7024034 (2006). */
    private static double[] planckianLocus(double temperature) {
        double t = 1000 / temperature;
        double x = temperature < 4000
                ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
        double y;
        if (temperature < 2222) {
            y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
        } else if (temperature < 4000) {
            y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
        } else {
            y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
        }
        return new double[] {x, y};
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 0.5, 0.8, 0.95, 1.05, 1.3, 2, 5, 100, 1e4, 1e8})
    void whiteIsAsBrightAsThatBlackBody(double dopplerFactor) {
        double expected = luminance(WHITE_TEMPERATURE * dopplerFactor) / luminance(WHITE_TEMPERATURE);
        Colour seen = ColourLaw.DOPPLER.seen(Colour.WHITE, dopplerFactor);
        assertThat(xyz(1, screenLight(seen)) / xyz(1, screenLight(Colour.WHITE)) / expected)
                .isCloseTo(1, within(0.02));
        // without the balance of white
        assertThat(ColourLaw.DOPPLER.brightness(dopplerFactor) / expected).isCloseTo(1, within(0.05));
    }

    private static double luminance(double temperature) {
        double sum = 0;
        for (int i = 0; i < LUMINOSITY.length; i++) {
            double wavelength = 380e-9 + 10e-9 * i;
            sum += LUMINOSITY[i] / Math.pow(wavelength, 5) / Math.expm1(0.0143877688 / (wavelength * temperature));
        }
        return sum;
    }

    @Test
    void whatIsVisibleComesFromBeyondOneEndOfTheColours() {
        // all that is seen at 2 is above 720 nm in the scene, at 0.5 below 415 nm, at 1.2 green comes from above 600 nm
        Colour white = ColourLaw.DOPPLER.seen(Colour.WHITE, 2);
        assertThat(ratios(ColourLaw.DOPPLER.seen(new Colour(1, 0, 0), 2), white))
                .allMatch(ratio -> ratio > 0.95);
        assertThat(ratios(ColourLaw.DOPPLER.seen(new Colour(0, 1, 0), 2), white))
                .allMatch(ratio -> ratio < 0.03);
        assertThat(ratios(ColourLaw.DOPPLER.seen(new Colour(0, 0, 1), 2), white))
                .allMatch(ratio -> ratio < 0.03);
        Colour red = ColourLaw.DOPPLER.seen(Colour.WHITE, 0.5);
        assertThat(ratios(ColourLaw.DOPPLER.seen(new Colour(0, 0, 1), 0.5), red))
                .allMatch(ratio -> ratio > 0.9);
        assertThat(ratios(ColourLaw.DOPPLER.seen(new Colour(1, 0, 0), 0.5), red))
                .allMatch(ratio -> ratio < 0.05);
        Colour yellow = ColourLaw.DOPPLER.seen(new Colour(1, 0, 0), 1.2);
        assertThat(yellow.green()).isGreaterThan(0.5 * yellow.red());
    }

    /**
     * What is left of a colour after a large shift: worked out by another program with the CIE 1931 tables, and metered
     * where D is the third number.
     */
    @ParameterizedTest
    @CsvSource({
        "GREEN, 9.93, 9.93, 0.0083, 0.0126, 0.0259", //
        "RED, 0.828, 1.3628, 0.00220, 0.00258, 0.00213"
    })
    void darkRemaindersAreThoseOfTheTables(
            String name, double dopplerFactor, double metered, double red, double green, double blue) {
        Colour light = name.equals("RED") ? new Colour(1, 0, 0) : new Colour(0, 1, 0);
        Colour seen = ColourLaw.DOPPLER.seen(light, dopplerFactor).times(1 / ColourLaw.DOPPLER.brightness(metered));
        assertThat(seen.red()).isCloseTo(red, withinPercentage(1));
        assertThat(seen.green()).isCloseTo(green, withinPercentage(1));
        assertThat(seen.blue()).isCloseTo(blue, withinPercentage(1));
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
        ColourMatching.table().stream()
                .filter(point -> point.wavelength() % 5 == 0 && point.wavelength() >= 380 && point.wavelength() <= 780)
                .forEach(point -> sum.add(point.xyz()));
        assertThat(sum.x).isCloseTo(21.371524, within(2e-6));
        assertThat(sum.y).isCloseTo(21.371327, within(2e-6));
        assertThat(sum.z).isCloseTo(21.371540, within(2e-6));
        assertThat(ColourMatching.table()).hasSize(471);
    }

    private static List<Double> ratios(Colour colour, Colour white) {
        return List.of(colour.red() / white.red(), colour.green() / white.green(), colour.blue() / white.blue());
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
