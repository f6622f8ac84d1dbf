package tompkins.surface;

import tompkins.property.Require;
import tompkins.ray.Colour;

/** Checks of fractions of light, which no surface may raise above 1. */
final class Transmission {

    private Transmission() {}

    static Colour required(String property, Colour fraction) {
        required(property + " (red)", fraction.red());
        required(property + " (green)", fraction.green());
        required(property + " (blue)", fraction.blue());
        return fraction;
    }

    static double required(String property, double fraction) {
        return Require.within(property, fraction, 0.0, 1.0);
    }
}
