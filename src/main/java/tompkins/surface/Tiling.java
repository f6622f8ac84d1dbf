package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/**
 * A chequerboard of two surfaces. Far away a pixel sees many tiles, and single rays would draw a false moire pattern; a
 * filtered tiling shows the fraction of each surface in the spot that the ray lights, worked out exactly: the mean of
 * the product of two square waves over the spot's box.
 */
@Meaning("A chequerboard of two surfaces")
public record Tiling(
        @Meaning("Surface of the tile at coordinates 0 to 1 tile, and of every second one")
        Surface first,

        @Meaning("Surface of the other tiles") Surface second,

        @Meaning(value = "Width of a tile, along the first coordinate", unit = "surface coordinate")
        double width,

        @Meaning(value = "Height of a tile, along the second coordinate", unit = "surface coordinate")
        double height,

        @Meaning("Whether tiles that are smaller than a pixel merge into their mean instead of flickering")
        boolean filtered)
        implements CompositeSurface {

    /** The spot of a ray is taken in so many parts at most. */
    static final int MOST_PARTS = 16;

    /** Grey and white unit tiles, filtered. */
    public static final Tiling DEFAULT = new Tiling(
            new ColouredSurface(Colour.grey(0.5), Colour.BLACK),
            new ColouredSurface(Colour.WHITE, Colour.BLACK),
            1,
            1,
            true);

    /** Checks the size. */
    public Tiling {
        Require.positive("width", width);
        Require.positive("height", height);
    }

    @Override
    public double fractionOfSecond(Ray ray, Hit hit) {
        SurfaceCoordinates at = hit.coordinates;
        double u = at.u() / width;
        double v = at.v() / height;
        if (!filtered) {
            return isSecond(u, v) ? 1 : 0;
        }
        double spreadU = at.spreadU(ray, hit) / width;
        double spreadV = at.spreadV(ray, hit) / height;
        double waves = SquareWave.mean(u, spreadU) * SquareWave.mean(v, spreadV);
        int parts = (int) Math.min(MOST_PARTS, Math.ceil(1 / Math.abs(hit.cosine(ray))));
        if (Math.abs(waves) < 1 && parts > 1) {
            waves = wavesOfParts(
                    u, v, spreadU, spreadV, at.alongU(ray, hit) / width, at.alongV(ray, hit) / height, parts);
        }
        return (1 - waves) / 2;
    }

    private static boolean isSecond(double u, double v) {
        return SquareWave.isOdd(Math.floor(u) + Math.floor(v));
    }

    /** A spot that lies obliquely fills little of the box around it, but most of the boxes around its parts. */
    private static double wavesOfParts(
            double u, double v, double spreadU, double spreadV, double alongU, double alongV, int parts) {
        double partU = partSpread(spreadU, alongU, parts);
        double partV = partSpread(spreadV, alongV, parts);
        double waves = 0;
        for (int part = 0; part < parts; part++) {
            double place = (2.0 * part + 1) / parts - 1;
            waves += SquareWave.mean(u + place * alongU, partU) * SquareWave.mean(v + place * alongV, partV);
        }
        return waves / parts;
    }

    /** The spread of a part: all of what lies across the long axis of the spot, and its fraction of what lies along. */
    static double partSpread(double spread, double along, int parts) {
        double across = Math.max(0, (spread - Math.abs(along)) * (spread + Math.abs(along)));
        double fraction = along / parts;
        return Math.sqrt(across + fraction * fraction);
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }

    @Override
    public boolean throwsShadowAt(Ray ray, Hit hit) {
        boolean isSecond = isSecond(hit.coordinates.u() / width, hit.coordinates.v() / height);
        return (isSecond ? second : first).throwsShadowAt(ray, hit);
    }
}
