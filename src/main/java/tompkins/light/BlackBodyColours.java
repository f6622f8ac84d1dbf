package tompkins.light;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Colour;

/**
 * The colours of a scene in the light of a black body, seen by a camera that moves.
 *
 * <p>A fast camera sees light that was invisible before, and three numbers say nothing about that. So each colour
 * stands for a surface in the light of a black body of 6504 K, the colour temperature of a screen's white, that
 * reflects as much of all light below 494 nm, of all between 494 and 590 nm, and of all above as gives the colour. With
 * these edges no colour of a screen needs a negative amount of any band. Black-body radiation of temperature T, seen
 * with Doppler factor D, is that of temperature D T, because spectral radiance divided by the cube of the frequency is
 * the same in all frames.
 */
final class BlackBodyColours {

    /** Temperature of the light that is white, in kelvins. */
    private static final double WHITE_TEMPERATURE = 6504;

    /** h c/k in nanometres times kelvins (CODATA 2018). */
    private static final double SECOND_RADIATION_CONSTANT = 1.438776877e7;

    // in nanometres
    private static final double FIRST_EDGE = 494;
    private static final double SECOND_EDGE = 590;

    /** Softness of the edges, so that sums over wavelengths are smooth. */
    private static final double SOFTNESS = 2;

    /** Farther away than so many softnesses an edge counts as sharp: exp(-40) added to 1 is 1. */
    private static final double NOT_TOLD_FROM_ONE = 40;

    /** The wavelength at which the fifth power in Planck's law counts as 1; any unit of light will do. */
    private static final double WEIGHT_ONE = 555;

    /** Linear sRGB from CIE 1931 XYZ (IEC 61966-2-1). */
    private static final Matrix3d SCREEN =
            new Matrix3d(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570);

    /** Logarithm of the smallest Doppler factor in the table: a black body of 196 K is invisible. */
    private static final double LEAST = -3.5;

    /** Logarithm of the largest one: beyond it the visible light of all black bodies grows with the temperature. */
    private static final double MOST = 9;

    static final int STEPS_PER_UNIT = 400;
    static final int ENTRIES = (int) ((MOST - LEAST) * STEPS_PER_UNIT) + 1;

    static final List<SpectralPoint> SPECTRUM = spectrum();

    private static final Matrix3d AT_REST = bands(1);

    /** The camera is balanced to the light in which the scene is white. */
    private static final Matrix3d BALANCE =
            new Matrix3d().scaling(new Vector3d(1).div(AT_REST.transform(new Vector3d(1))));

    /** How much of each band, long waves first, a colour of the screen stands for. */
    private static final Matrix3d WEIGHTS = BALANCE.mul(AT_REST, new Matrix3d()).invert();

    /** For each Doppler factor nine numbers, row by row: colour in the scene to colour in the camera frame. */
    private static final double[] TABLE = table();

    private BlackBodyColours() {}

    /** The colour in the camera frame; what a screen cannot show of it is left out. */
    static Colour seen(Colour light, double dopplerFactor) {
        double position = position(dopplerFactor);
        return new Colour(
                Math.max(0, channel(0, light, position)),
                Math.max(0, channel(1, light, position)),
                Math.max(0, channel(2, light, position)));
    }

    /**
     * The colour in the camera frame of a black body whose luminance is 1 in its rest frame; what a screen cannot show
     * of it is left out.
     *
     * @param temperature in kelvins, in its rest frame
     */
    static Colour ofTemperature(double temperature, double dopplerFactor) {
        double factor = temperature / WHITE_TEMPERATURE;
        return seen(Colour.WHITE, dopplerFactor * factor).times(1 / brightness(factor));
    }

    /**
     * The colour in the camera frame of light that a moving lamp has sent to a surface. The surface's bands have their
     * edges in its rest frame, so they are shifted once; the black body is shifted on the whole way.
     *
     * @param light the colour, as if lamp and surface had one frame
     * @param temperatureFactor frequency in the camera frame divided by that in the frame of the lamp
     * @param edgeFactor frequency in the camera frame divided by that in the frame of the surface
     */
    static Colour seen(Colour light, double temperatureFactor, double edgeFactor) {
        double position = position(temperatureFactor);
        if (!(position >= 0)) {
            return Colour.BLACK;
        }
        int before = (int) Math.min(position, ENTRIES - 2.0);
        double fraction = Math.min(1, position - before);
        double beyond = Math.max(0, position - (ENTRIES - 1)) / STEPS_PER_UNIT;
        Vector3d amounts = WEIGHTS.transform(new Vector3d(light.red(), light.green(), light.blue()));
        double logEdge = Math.log(edgeFactor);
        Vector3d sum = seen(before, logEdge, amounts)
                .lerp(seen(before + 1, logEdge, amounts), fraction)
                .mul(Math.exp(beyond));
        return new Colour(Math.max(0, sum.x), Math.max(0, sum.y), Math.max(0, sum.z));
    }

    /** The colour for an entry of the temperature, of amounts of the long, the middle and the short waves. */
    private static Vector3d seen(int index, double logEdge, Vector3dc amounts) {
        Vector3d first = new Vector3d();
        Vector3d second = new Vector3d();
        LampShiftTable.bands(index, dopplerFactor(index), logEdge, first, second);
        // all, as a matrix for amounts of 1, is the white that the other table holds
        Vector3d all = new Vector3d(
                entry(index, 0, Colour.WHITE), entry(index, 1, Colour.WHITE), entry(index, 2, Colour.WHITE));
        return BALANCE.transform(second.mul(amounts.x() - amounts.y()).add(first.mul(amounts.y() - amounts.z())))
                .fma(amounts.z(), all);
    }

    /** The luminance in the camera frame of a black body, divided by that in its rest frame. */
    static double brightness(double temperature, double dopplerFactor) {
        double factor = temperature / WHITE_TEMPERATURE;
        return brightness(dopplerFactor * factor) / brightness(factor);
    }

    /** The luminance in the camera frame of what is white in the scene. */
    static double brightness(double dopplerFactor) {
        double position = position(dopplerFactor);
        return Colour.luminance(
                channel(0, Colour.WHITE, position),
                channel(1, Colour.WHITE, position),
                channel(2, Colour.WHITE, position));
    }

    /** The position of a Doppler factor in the table, in entries. */
    private static double position(double dopplerFactor) {
        return (Math.log(dopplerFactor) - LEAST) * STEPS_PER_UNIT;
    }

    private static double channel(int row, Colour light, double position) {
        if (position < 0) {
            return 0;
        }
        double beyond = position - (ENTRIES - 1);
        if (beyond >= 0) {
            return entry(ENTRIES - 1, row, light) * Math.exp(beyond / STEPS_PER_UNIT);
        }
        int before = (int) position;
        double fraction = position - before;
        return (1 - fraction) * entry(before, row, light) + fraction * entry(before + 1, row, light);
    }

    private static double entry(int index, int row, Colour light) {
        int first = 9 * index + 3 * row;
        return TABLE[first] * light.red() + TABLE[first + 1] * light.green() + TABLE[first + 2] * light.blue();
    }

    private static double[] table() {
        double[] table = new double[9 * ENTRIES];
        for (int index = 0; index < ENTRIES; index++) {
            Matrix3d change =
                    BALANCE.mul(bands(dopplerFactor(index)), new Matrix3d()).mul(WEIGHTS);
            // JOML stores columns, the table holds rows
            change.transpose().get(table, 9 * index);
        }
        return table;
    }

    /** The Doppler factor of an entry of the table. */
    private static double dopplerFactor(int index) {
        return Math.exp(LEAST + (double) index / STEPS_PER_UNIT);
    }

    /** A wavelength L, and what it adds to the screen for each unit of 1/(exp(h c/(L k T)) - 1). */
    record SpectralPoint(double wavelength, Vector3dc weight) {}

    /**
     * By the colour-matching functions of the CIE 1931 standard observer, from 360 to 830 nm in steps of 1 nm (G.
     * Wyszecki, W. S. Stiles, Color Science, 2nd edition (1982), table I(3.3.1)).
     */
    private static List<SpectralPoint> spectrum() {
        return ResourceTable.lines("cie-1931.csv").stream()
                .map(cells -> Stream.of(cells).mapToDouble(Double::parseDouble).toArray())
                .map(point -> new SpectralPoint(
                        point[0],
                        SCREEN.transform(new Vector3d(point[1], point[2], point[3]))
                                .mul(Math.pow(point[0] / WEIGHT_ONE, -5))))
                .toList();
    }

    /** The screen's colours, as columns, of the three bands of the black body: long wavelengths, middle, short. */
    private static Matrix3d bands(double dopplerFactor) {
        Vector3d longWaves = new Vector3d();
        Vector3d middle = new Vector3d();
        Vector3d shortWaves = new Vector3d();
        for (SpectralPoint point : SPECTRUM) {
            double planck = planck(dopplerFactor, point.wavelength());
            double inScene = dopplerFactor * point.wavelength();
            double aboveFirst = aboveFirst(inScene);
            double aboveSecond = aboveSecond(inScene);
            longWaves.fma(aboveSecond * planck, point.weight());
            middle.fma((aboveFirst - aboveSecond) * planck, point.weight());
            shortWaves.fma((1 - aboveFirst) * planck, point.weight());
        }
        return new Matrix3d(longWaves, middle, shortWaves);
    }

    /** The Planck factor of a black body whose temperature is given as a multiple of that of white light. */
    static double planck(double temperatureFactor, double wavelength) {
        double exponent = SECOND_RADIATION_CONSTANT / (temperatureFactor * WHITE_TEMPERATURE);
        return 1 / Math.expm1(exponent / wavelength);
    }

    /** The fraction of a wavelength that belongs to the middle or the long waves. */
    static double aboveFirst(double wavelength) {
        return above(FIRST_EDGE, wavelength);
    }

    /** The fraction of a wavelength that belongs to the long waves. */
    static double aboveSecond(double wavelength) {
        return above(SECOND_EDGE, wavelength);
    }

    private static double above(double edge, double wavelength) {
        double depth = (edge - wavelength) / SOFTNESS;
        if (Math.abs(depth) > NOT_TOLD_FROM_ONE) {
            return depth < 0 ? 1 : 0;
        }
        return 1 / (1 + Math.exp(depth));
    }
}
