package tompkins.studio;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.light.Star;
import tompkins.light.StarCatalogue;
import tompkins.math.Vectors;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;

/**
 * The bright stars of the night sky, at rest in the scene and so far away that they show no parallax, over an even
 * colour. They give no light to objects.
 */
@Meaning("The bright stars of the night sky, infinitely far away and at rest in the scene; they light nothing")
public record StarSky(
        @Meaning("The faintest visual magnitude that is shown, as seen at rest, from -2 to 6.5")
        double limit,

        @Meaning(
                value = "Solid angle of white surface that gives as much light as a star of magnitude 0, up to 1000",
                unit = "square degrees")
        double zeroMagnitudeSquareDegrees,

        @Meaning("Direction of the celestial north pole, of any length")
        Vector3dc north,

        @Meaning("Direction of right ascension 0, as far as the pole allows")
        Vector3dc zeroHour,

        @Meaning("Colour of the sky between the stars") Colour colour)
        implements Background {

    private static final double SQUARE_DEGREE = Math.pow(Math.toRadians(1), 2);

    /** Directions that are nearer to each other count as parallel. */
    private static final double SMALLEST_SINE = 1e-9;

    /** A dark night, as bright as the eye sees it. */
    public static final StarSky DEFAULT =
            new StarSky(6, 0.2, new Vector3d(0, 1, 0), new Vector3d(0, 0, 1), Colour.BLACK);

    /** Checks all values. */
    public StarSky {
        Require.within("limit", limit, -2.0, StarCatalogue.FAINTEST);
        Require.positive("zeroMagnitudeSquareDegrees", zeroMagnitudeSquareDegrees, 1000);
        north = Require.direction("north", north);
        zeroHour = Require.direction("zeroHour", zeroHour);
        if (Vectors.cross(Vectors.unit(north), Vectors.unit(zeroHour)).length() < SMALLEST_SINE) {
            throw new InvalidPropertyException(
                    "zeroHour", "not parallel to north " + Require.text(north), Require.text(zeroHour));
        }
        Colour.required("colour", colour);
    }

    @Override
    public Colour colour(double dx, double dy, double dz, double angle) {
        return colour;
    }

    /** The solid angle, in steradians, of white surface that gives as much light as a star seen at rest. */
    public double solidAngle(Star star) {
        return star.light() * zeroMagnitudeSquareDegrees * SQUARE_DEGREE;
    }

    /** The unit vector in the scene frame to a star; east is to the left when north is up. */
    public Vector3d direction(Star star) {
        Vector3d up = Vectors.unit(north);
        Vector3d right = Vectors.unit(Vectors.cross(up, Vectors.unit(zeroHour)));
        Vector3d ahead = right.cross(up, new Vector3d());
        double declination = Math.toRadians(star.declinationDegrees());
        double rightAscension = Math.toRadians(star.rightAscensionDegrees());
        double level = Math.cos(declination);
        return right.mul(-level * Math.sin(rightAscension))
                .fma(Math.sin(declination), up)
                .fma(level * Math.cos(rightAscension), ahead);
    }
}
