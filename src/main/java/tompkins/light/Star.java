package tompkins.light;

/**
 * A star of the {@linkplain StarCatalogue catalogue}.
 *
 * @param rightAscensionDegrees from 0 to 360 (ICRS, epoch 2000)
 * @param declinationDegrees from -90 to 90
 * @param magnitude the visual magnitude V
 * @param colourIndex B-V: below 0 for blue stars, above 1 for red ones
 */
public record Star(double rightAscensionDegrees, double declinationDegrees, double magnitude, double colourIndex) {

    /** The bluest colour index for which the formula of the temperature holds. */
    private static final double BLUEST = -0.4;

    /** The light that comes from it, in units of that of a star of magnitude 0: five magnitudes are a factor of 100. */
    public double light() {
        return Math.pow(10, -0.4 * magnitude);
    }

    /**
     * The temperature in kelvins of the black body that has the colour of the star (F. J. Ballesteros, EPL 97 (2012)
     * 34008). Dust on the way reddens a star, so it may itself be hotter.
     */
    public double temperature() {
        double slope = 0.92 * Math.max(BLUEST, colourIndex);
        return 4600 * (1 / (slope + 1.7) + 1 / (slope + 0.62));
    }
}
