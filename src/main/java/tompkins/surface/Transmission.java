package tompkins.surface;

import tompkins.property.Require;
import tompkins.ray.Colour;

/** Checks of shares of light, which no surface may raise above 1. */
final class Transmission {

    private Transmission() {}

    static Colour required(String property, Colour share) {
        required(property + " (red)", share.red());
        required(property + " (green)", share.green());
        required(property + " (blue)", share.blue());
        return share;
    }

    static double required(String property, double share) {
        return Require.within(property, share, 0.0, 1.0);
    }
}
