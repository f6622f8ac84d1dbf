package tompkins.light;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Powers;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/**
 * A small bright light that throws sharp shadows and highlights and does not fade with distance. The reflected light is
 * the sum of a diffuse part, proportional to the cosine between normal and light, and a highlight, a power of the
 * cosine between the mirrored light and the ray (Phong's model).
 */
@Meaning("A small bright light that throws sharp shadows and highlights and does not fade with distance")
public record PointLight(
        @Meaning(value = "Where the light is", unit = "length")
        Vector3dc position,

        @Meaning("Colour and brightness of the light on dull surfaces")
        Colour colour,

        @Meaning("Colour and brightness of the highlights on shiny surfaces")
        Colour highlightColour,

        @Meaning("How small the highlights are: the power of the cosine")
        double highlightExponent,

        @Meaning("When the light shines") Flash flash)
        implements RestingLight {

    /** A white light behind, above and to the right of the camera. */
    public static final PointLight DEFAULT =
            new PointLight(new Vector3d(100, 300, -500), Colour.WHITE, Colour.WHITE, 40);

    /** In the frame of a moving camera, a lamp may be farther away than any place in a description. */
    private static final double FARTHEST = 1e100;

    /** Checks all values. */
    public PointLight {
        position = Require.position("position", position, FARTHEST);
        Colour.required("colour", colour);
        Colour.required("highlightColour", highlightColour);
        Require.notNegative("highlightExponent", highlightExponent);
        Require.present("flash", flash);
    }

    /** A light that shines all the time. */
    public PointLight(Vector3dc position, Colour colour, Colour highlightColour, double highlightExponent) {
        this(position, colour, highlightColour, highlightExponent, AlwaysOn.DEFAULT);
    }

    @Override
    public void reflect(Ray ray, Hit hit, Colour diffuse, Colour specular, Illumination sum) {
        Sightline sight = sum.sight();
        if (sight == null) {
            return;
        }
        double lx = sight.x;
        double ly = sight.y;
        double lz = sight.z;
        double lightAlongNormal = lx * hit.normalX + ly * hit.normalY + lz * hit.normalZ;
        boolean behind = lightAlongNormal * hit.cosine(ray) > 0;
        double distance = sight.length;
        if (behind || distance == 0 || !flash.isLit(sight.emission) || !sum.isClear()) {
            return;
        }
        double dull = Math.abs(lightAlongNormal) / distance;
        double cosine = mirroredCosine(ray, hit, lx, ly, lz, lightAlongNormal);
        double shine = cosine > 0 ? Powers.power(cosine, highlightExponent) : 0;
        sum.add(
                diffuse.red() * colour.red() * dull + specular.red() * highlightColour.red() * shine,
                diffuse.green() * colour.green() * dull + specular.green() * highlightColour.green() * shine,
                diffuse.blue() * colour.blue() * dull + specular.blue() * highlightColour.blue() * shine,
                sight.dopplerFactor);
    }

    /** Cosine between the ray and the light that the surface mirrors; both point into the surface. */
    private static double mirroredCosine(Ray ray, Hit hit, double lx, double ly, double lz, double lightAlongNormal) {
        double mx = lx - 2 * lightAlongNormal * hit.normalX;
        double my = ly - 2 * lightAlongNormal * hit.normalY;
        double mz = lz - 2 * lightAlongNormal * hit.normalZ;
        double along = mx * ray.dx + my * ray.dy + mz * ray.dz;
        return along > 0 ? Math.min(1, along / Math.sqrt(mx * mx + my * my + mz * mz)) : 0;
    }

    @Override
    public PointLight seenFrom(Vector3dc origin) {
        return shifted(origin.negate(new Vector3d()));
    }

    /** The same light elsewhere: farther by a vector. */
    public PointLight shifted(Vector3dc by) {
        return new PointLight(position.add(by, new Vector3d()), colour, highlightColour, highlightExponent, flash);
    }
}
