package tompkins.ray;

import tompkins.property.Require;

/**
 * A colour in linear light: white is (1, 1, 1), values above 1 are brighter than the picture can show.
 *
 * @param red from 0 upwards
 * @param green from 0 upwards
 * @param blue from 0 upwards
 */
public record Colour(double red, double green, double blue) {

    /** No light. */
    public static final Colour BLACK = new Colour(0, 0, 0);

    /** The brightest colour of the picture. */
    public static final Colour WHITE = new Colour(1, 1, 1);

    /** Pictures hold floats, up to 2^128; this limit leaves room for a sum of a million samples. */
    private static final double LARGEST = 0x1p104;

    /** The most that a description may ask for, so that the light of many lamps still fits into a picture. */
    private static final double BRIGHTEST = 1e20;

    /** The same value in all channels. */
    public static Colour grey(double value) {
        return new Colour(value, value, value);
    }

    /**
     * The colour, if a description may use it.
     *
     * @throws tompkins.property.InvalidPropertyException if it is missing, or a channel is not from 0 to 1e20
     */
    public static Colour required(String property, Colour colour) {
        Require.present(property, colour);
        Require.within(property + " (red)", colour.red, 0, BRIGHTEST);
        Require.within(property + " (green)", colour.green, 0, BRIGHTEST);
        Require.within(property + " (blue)", colour.blue, 0, BRIGHTEST);
        return colour;
    }

    /** The luminance of light with the primaries of screens (ITU-R BT.709); that of white is 1. */
    public static double luminance(double red, double green, double blue) {
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    }

    /** The luminance; that of white is 1. */
    public double luminance() {
        return luminance(red, green, blue);
    }

    /** The sum, channel by channel. */
    public Colour plus(Colour other) {
        return new Colour(red + other.red, green + other.green, blue + other.blue);
    }

    /** The product, channel by channel. */
    public Colour times(Colour other) {
        return new Colour(red * other.red, green * other.green, blue * other.blue);
    }

    /** All channels multiplied by one number. */
    public Colour times(double factor) {
        return new Colour(red * factor, green * factor, blue * factor);
    }

    /** The brightest channel. */
    public double brightest() {
        return Math.max(red, Math.max(green, blue));
    }

    /** Whether all channels are numbers that a picture can hold. */
    public boolean isFinite() {
        return Math.abs(red + green + blue) <= LARGEST;
    }
}
