package tompkins.studio;

import tompkins.property.Meaning;
import tompkins.ray.Colour;

/** A sky that fades from the horizon to the zenith, over ground of one colour. */
@Meaning("A sky that fades from the horizon to the zenith, over ground of one colour")
public record SkyBackground(
        @Meaning("Colour straight up") Colour zenith,
        @Meaning("Colour of the sky at the horizon") Colour horizon,
        @Meaning("Colour below the horizon") Colour ground)
        implements Background {

    /** A clear day. */
    public static final SkyBackground DEFAULT =
            new SkyBackground(new Colour(0.2, 0.4, 0.9), new Colour(0.85, 0.9, 1), Colour.grey(0.3));

    /** Checks the colours. */
    public SkyBackground {
        Colour.required("zenith", zenith);
        Colour.required("horizon", horizon);
        Colour.required("ground", ground);
    }

    @Override
    public Colour colour(double dx, double dy, double dz, double angle) {
        double fraction = Math.min(1, dy);
        return dy < 0 ? ground : horizon.times(1 - fraction).plus(zenith.times(fraction));
    }
}
