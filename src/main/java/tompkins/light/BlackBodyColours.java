package tompkins.light;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import tompkins.ray.Colour;

/**
 * The colours of a scene in the light of a black body, seen by a camera that moves.
 *
 * <p>Three numbers say nothing of what lies beyond the visible, and that is what a fast camera sees. So each colour
 * stands for a surface in the light of a black body of 6504 K, the colour temperature of a screen's white, that
 * reflects as much of all light below 494 nm, of all between 494 and 590 nm, and of all above as gives the colour. With
 * these edges no colour of a screen needs a negative amount of any band. Black-body radiation of temperature T, seen
 * with Doppler factor D, is that of temperature D T, because radiance divided by the cube of the frequency is the same
 * in all frames.
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

    private static final int SHORTEST = 360;
    private static final int LONGEST = 830;
    private static final int STEP = 2;

    /** Linear sRGB from CIE 1931 XYZ (IEC 61966-2-1). */
    private static final Matrix3d SCREEN =
            new Matrix3d(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570);

    /** Share of the channels in the luminance. */
    private static final Vector3d LUMINANCE = new Vector3d(0.2126, 0.7152, 0.0722);

    /** Logarithm of the smallest Doppler factor in the table: a black body of 196 K, which nobody sees. */
    private static final double LEAST = -3.5;

    /** Logarithm of the largest one: beyond it the visible light of all black bodies grows with the temperature. */
    private static final double MOST = 9;

    private static final int STEPS_PER_UNIT = 200;
    private static final int ENTRIES = (int) ((MOST - LEAST) * STEPS_PER_UNIT) + 1;

    /**
     * For each Doppler factor the nine numbers, row by row, that make the colour in the camera frame of that in the
     * scene.
     */
    private static final double[] TABLE = table();

    private BlackBodyColours() {}

    /** The colour in the camera frame; what a screen cannot show of it is left out. */
    static Colour seen(Colour light, double dopplerFactor) {
        double place = place(dopplerFactor);
        return new Colour(
                Math.max(0, channel(0, light, place)),
                Math.max(0, channel(1, light, place)),
                Math.max(0, channel(2, light, place)));
    }

    /** The luminance in the camera frame of what is white in the scene. */
    static double brightness(double dopplerFactor) {
        double place = place(dopplerFactor);
        return LUMINANCE.x * channel(0, Colour.WHITE, place)
                + LUMINANCE.y * channel(1, Colour.WHITE, place)
                + LUMINANCE.z * channel(2, Colour.WHITE, place);
    }

    /** Where a Doppler factor stands in the table, in entries. */
    private static double place(double dopplerFactor) {
        return (Math.log(dopplerFactor) - LEAST) * STEPS_PER_UNIT;
    }

    private static double channel(int row, Colour light, double place) {
        if (place < 0) {
            return 0;
        }
        double beyond = place - (ENTRIES - 1);
        if (beyond >= 0) {
            return entry(ENTRIES - 1, row, light) * Math.exp(beyond / STEPS_PER_UNIT);
        }
        int before = (int) place;
        double share = place - before;
        return (1 - share) * entry(before, row, light) + share * entry(before + 1, row, light);
    }

    private static double entry(int place, int row, Colour light) {
        int first = 9 * place + 3 * row;
        return TABLE[first] * light.red() + TABLE[first + 1] * light.green() + TABLE[first + 2] * light.blue();
    }

    private static double[] table() {
        Matrix3d atRest = bands(1);
        Vector3d white = atRest.transform(new Vector3d(1));
        // the camera is balanced to the light in which the scene is white
        Matrix3d balance = new Matrix3d().scaling(1 / white.x, 1 / white.y, 1 / white.z);
        Matrix3d shares = balance.mul(atRest, new Matrix3d()).invert();
        double[] table = new double[9 * ENTRIES];
        for (int place = 0; place < ENTRIES; place++) {
            double dopplerFactor = Math.exp(LEAST + (double) place / STEPS_PER_UNIT);
            Matrix3d change = balance.mul(bands(dopplerFactor), new Matrix3d()).mul(shares);
            // JOML stores columns, the table holds rows
            change.transpose().get(table, 9 * place);
        }
        return table;
    }

    /** The screen's colours, as columns, of the three bands of the black body: long wavelengths, middle, short. */
    private static Matrix3d bands(double dopplerFactor) {
        Vector3d longWaves = new Vector3d();
        Vector3d middle = new Vector3d();
        Vector3d shortWaves = new Vector3d();
        for (int wavelength = SHORTEST; wavelength <= LONGEST; wavelength += STEP) {
            double radiance = radiance(wavelength, dopplerFactor * WHITE_TEMPERATURE);
            Vector3d seen = SCREEN.transform(matching(wavelength)).mul(radiance);
            double inScene = dopplerFactor * wavelength;
            double aboveFirst = above(FIRST_EDGE, inScene);
            double aboveSecond = above(SECOND_EDGE, inScene);
            longWaves.fma(aboveSecond, seen);
            middle.fma(aboveFirst - aboveSecond, seen);
            shortWaves.fma(1 - aboveFirst, seen);
        }
        return new Matrix3d(longWaves, middle, shortWaves);
    }

    /** Planck's law, in any unit. */
    private static double radiance(double wavelength, double temperature) {
        return Math.pow(wavelength / SHORTEST, -5) / Math.expm1(SECOND_RADIATION_CONSTANT / (wavelength * temperature));
    }

    private static double above(double edge, double wavelength) {
        return 1 / (1 + Math.exp((edge - wavelength) / SOFTNESS));
    }

    /**
     * The CIE 1931 colour-matching functions, after C. Wyman, P.-P. Sloan, P. Shirley, JCGT 2(2) (2013), equation (4).
     */
    private static Vector3d matching(double wavelength) {
        return new Vector3d(
                0.362 * lobe(wavelength, 442.0, 0.0624, 0.0374)
                        + 1.056 * lobe(wavelength, 599.8, 0.0264, 0.0323)
                        - 0.065 * lobe(wavelength, 501.1, 0.0490, 0.0382),
                0.821 * lobe(wavelength, 568.8, 0.0213, 0.0247) + 0.286 * lobe(wavelength, 530.9, 0.0613, 0.0322),
                1.217 * lobe(wavelength, 437.0, 0.0845, 0.0278) + 0.681 * lobe(wavelength, 459.0, 0.0385, 0.0725));
    }

    private static double lobe(double wavelength, double peak, double narrownessBelow, double narrownessAbove) {
        double distance = (wavelength - peak) * (wavelength < peak ? narrownessBelow : narrownessAbove);
        return Math.exp(-distance * distance / 2);
    }
}
