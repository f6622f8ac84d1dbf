package tompkins.studio;

import tompkins.ray.Colour;

/** What a ray sees if it meets nothing in the scene: a colour for each direction. */
public sealed interface Background permits UniformBackground, SkyBackground, PanoramaBackground, StarSky {

    /**
     * The light from a direction, a unit vector in the scene frame.
     *
     * @param angle the angle in radians over which a filtered background shows its mean; 0 for the direction alone
     */
    Colour colour(double dx, double dy, double dz, double angle);
}
